#include <stdexcept>

namespace {
int Throw() { throw std::runtime_error("no calibration"); }
[[maybe_unused]] const int kThrown = Throw();
}  // namespace
