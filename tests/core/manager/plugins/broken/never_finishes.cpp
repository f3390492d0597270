#include <chrono>
#include <thread>

namespace {
struct Wait {
  Wait() {
    while (true) std::this_thread::sleep_for(std::chrono::hours(1));
  }
};
const Wait kWait;
}  // namespace
