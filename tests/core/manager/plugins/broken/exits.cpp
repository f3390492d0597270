#include <cstdio>
#include <cstdlib>

namespace {
struct Exit {
  Exit() {
    std::puts("plug-in or not");
    std::exit(0);
  }
};
const Exit kExit;
}  // namespace
