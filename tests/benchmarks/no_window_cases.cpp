#include <benchmarks/case.h>

namespace tendon::benchmark {

/// The window is not built in.
std::vector<Case> PlotCases(const Effort& /*effort*/) { return {}; }
std::vector<Case> WindowCases(const Effort& /*effort*/) { return {}; }

}  // namespace tendon::benchmark
