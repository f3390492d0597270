// The other end of the measurements between processes: the GCM, a process "robot" that has joined
// it, and raw Ice. Prints where they are reached, in the order of RemoteSystem::Addresses, and runs
// until it is killed.

#include <benchmarks/remote/robot.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/ice/ice_middleware.h>
#include <tendon/process/process.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <iostream>

int main() {
  using namespace tendon;
  const auto gcm =
      GlobalManager::Start(MakeIceMiddleware(Exposure::kLoopbackOnly), {.address = "127.0.0.1:0"});
  if (!gcm) return EXIT_FAILURE;
  Process process("robot", {.middleware = MakeIceMiddleware(Exposure::kLoopbackOnly),
                            .gcm = (*gcm)->address()});
  process.Add<benchmark::Robot>("robot");
  if (!process.StartAll() || !process.WaitUntilJoined(std::chrono::seconds(30))) {
    return EXIT_FAILURE;
  }
  const benchmark::RawIceServer raw;
  std::cout << (*gcm)->address() << ' ' << process.address() << ' ' << raw.address() << ' '
            << raw.address_of_one_thread() << std::endl;
  while (true) pause();
}
