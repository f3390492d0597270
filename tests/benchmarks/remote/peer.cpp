// The other process of the measurements. It contains the GCM, a process "robot" that has joined the
// GCM, and a server of raw Ice. Prints their addresses in the order of RemoteSystem::Addresses, and
// runs until it is killed. At SIGUSR1 it starts the other middlewares and prints their addresses.

#include <benchmarks/memory.h>
#include <benchmarks/remote/rivals/rival.h>
#include <benchmarks/remote/robot.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/ice/ice_middleware.h>
#include <tendon/process/process.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <vector>

int main() {
  using namespace tendon;
  benchmark::KeepMemory();
  sigset_t begin_rivals;
  sigemptyset(&begin_rivals);
  sigaddset(&begin_rivals, SIGUSR1);
  pthread_sigmask(SIG_BLOCK, &begin_rivals, nullptr);  // all later threads inherit this mask
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
  std::vector<std::unique_ptr<benchmark::RivalServer>> rivals;
  for (int signal = 0; sigwait(&begin_rivals, &signal) == 0;) {
    for (const auto& rival : benchmark::Rivals()) {
      if (!rival.missing.empty()) continue;
      rivals.push_back(rival.serve());
      std::cout << rivals.back()->address() << ' ';
    }
    std::cout << std::endl;
  }
}
