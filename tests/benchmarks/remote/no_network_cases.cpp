#include <benchmarks/case.h>

namespace tendon::benchmark {

/// They compare with Ice, which is not built in.
std::vector<Case> NetworkCases(const Effort& /*effort*/) { return {}; }

}  // namespace tendon::benchmark
