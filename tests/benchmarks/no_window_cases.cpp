#include <benchmarks/case.h>

namespace tendon::benchmark {

/// For a build without the window.
std::vector<Case> PlotCases(const Effort& /*effort*/) { return {}; }
std::vector<Case> WindowCases(const Effort& /*effort*/) { return {}; }

}  // namespace tendon::benchmark
