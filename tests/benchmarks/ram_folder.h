#pragma once

#include <tendon/base/os/process.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace tendon::benchmark {

/// A folder in memory, so that no disk is measured. If there is no RAM disk, the folder is among
/// the temporary files. The destructor removes the folder.
class RamFolder {
 public:
  RamFolder() {
    const std::filesystem::path ram = "/dev/shm";
    path_ = std::filesystem::is_directory(ram) ? ram : std::filesystem::temp_directory_path();
    path_ /= "tendon-report-" + std::to_string(os::RandomNumber());
    std::filesystem::create_directories(path_);
  }
  RamFolder(const RamFolder&) = delete;
  RamFolder& operator=(const RamFolder&) = delete;
  ~RamFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace tendon::benchmark
