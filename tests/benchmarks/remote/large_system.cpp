#include <benchmarks/memory.h>
#include <benchmarks/remote/large_system.h>
#include <support/wait.h>
#include <tendon/base/os/process.h>

#include <algorithm>
#include <csignal>
#include <fstream>

namespace tendon::benchmark {
namespace {

bool IsStopped(int pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("State:")) return line.find('T') != std::string::npos;
  }
  return false;
}

}  // namespace

LargeSystem::LargeSystem(const RemoteSystem& system, int processes, int components_of_each)
    : address_("127.0.0.1:" + std::to_string(FreePort())),
      gcm_({TENDON_GCM, "serve", "--gcm", address_}, system.environment()) {
  for (int i = 0; i < processes; ++i) {
    crowd_.push_back(std::make_unique<Program>(
        Program::Words{os::ProgramFolder() / "report_crowd", "crowd" + std::to_string(i), address_,
                       std::to_string(components_of_each)},
        system.environment()));
  }
  Require(EventuallyTrue([&] {
            return std::ranges::all_of(crowd_,
                                       [](const auto& one) { return IsStopped(one->pid()); });
          }),
          "the processes do not start");
}

double LargeSystem::MemoryOfGcm() const {
  return MemoryFigure(std::to_string(gcm_.pid()), "VmRSS");
}

void LargeSystem::Join() {
  for (const auto& one : crowd_) one->Signal(SIGCONT);
}

}  // namespace tendon::benchmark
