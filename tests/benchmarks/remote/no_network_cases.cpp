#include <benchmarks/case.h>

namespace tendon::benchmark {

/// For a build without Ice: these cases compare with Ice.
std::vector<Case> NetworkCases(const Effort& /*effort*/) { return {}; }

}  // namespace tendon::benchmark
