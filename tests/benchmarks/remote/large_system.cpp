#include <benchmarks/remote/large_system.h>
#include <support/wait.h>
#include <tendon/base/os/process.h>

#include <algorithm>
#include <csignal>
#include <fstream>

namespace tendon::benchmark {
namespace {

/// Returns the line that begins with `name` in a file of the process in /proc.
std::string LineOf(int pid, const std::string& file, const std::string& name) {
  std::ifstream lines("/proc/" + std::to_string(pid) + "/" + file);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(name)) return line.substr(name.size());
  }
  return {};
}

bool IsStopped(int pid) { return LineOf(pid, "status", "State:").find('T') != std::string::npos; }

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
  constexpr double kKiB = 1024;
  return kKiB * std::stod(LineOf(gcm_.pid(), "status", "VmRSS:"));
}

void LargeSystem::Join() {
  for (const auto& one : crowd_) one->Signal(SIGCONT);
}

}  // namespace tendon::benchmark
