#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace faults {

/// While this object exists, a process cannot create threads. The limit of the user prevents this.
/// Root has no such limit, so for root a control group is used.
class ThreadLimit {
 public:
  explicit ThreadLimit(int pid) : pid_(pid) {
    if (geteuid() != 0) {
      prlimit(pid_, RLIMIT_NPROC, nullptr, &usual_);
      const rlimit none{.rlim_cur = 1, .rlim_max = usual_.rlim_max};
      holds_ = prlimit(pid_, RLIMIT_NPROC, &none, nullptr) == 0;
      return;
    }
    std::error_code failure;
    std::filesystem::create_directory(group_, failure);
    holds_ = !failure && Write(group_ / "pids.max", "1") && Move(group_);
  }
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;
  ~ThreadLimit() {
    if (geteuid() != 0) {
      if (holds_) prlimit(pid_, RLIMIT_NPROC, &usual_, nullptr);
      return;
    }
    if (holds_) (void)Move(before_);
    rmdir(group_.c_str());
  }

  [[nodiscard]] bool holds() const { return holds_; }

 private:
  static bool Write(const std::filesystem::path& file, const std::string& text) {
    return static_cast<bool>(std::ofstream(file) << text << std::flush);
  }
  [[nodiscard]] bool Move(const std::filesystem::path& group) const {
    return Write(group / "cgroup.procs", std::to_string(pid_));
  }
  /// Returns the folder of all control groups, in version 1 or 2 of the kernel's interface.
  static std::filesystem::path Root() {
    const std::filesystem::path root("/sys/fs/cgroup");
    return std::filesystem::exists(root / "pids") ? root / "pids" : root;
  }
  /// Returns the control group of a process.
  static std::filesystem::path GroupOf(int pid) {
    const std::string name = Root().filename() == "pids" ? ":pids:" : "0::";
    std::ifstream lines("/proc/" + std::to_string(pid) + "/cgroup");
    for (std::string line; std::getline(lines, line);) {
      const auto at = line.find(name);
      if (at != line.npos) return Root() / line.substr(at + name.size() + 1);
    }
    return Root();
  }

  const int pid_;
  const std::filesystem::path before_ = GroupOf(pid_);
  const std::filesystem::path group_ = Root() / ("tendon-" + std::to_string(pid_));
  rlimit usual_{};
  bool holds_ = false;
};

}  // namespace faults
