#include <csignal>

namespace {
[[maybe_unused]] const int kCrash = std::raise(SIGSEGV);
}  // namespace
