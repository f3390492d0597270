#pragma once

#include <tendon/base/os/process.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace tendon::test {

/// An empty private folder. The destructor removes the folder.
class Folder {
 public:
  Folder()
      : path_(std::filesystem::temp_directory_path() /
              ("tendon-test-" + std::to_string(os::RandomNumber()))) {
    std::filesystem::create_directories(path_);
    std::filesystem::permissions(path_, std::filesystem::perms::owner_all);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
  }
  [[nodiscard]] std::string Read(const std::string& name) const {
    std::stringstream text;
    text << std::ifstream(path_ / name, std::ios::binary).rdbuf();
    return text.str();
  }

 private:
  const std::filesystem::path path_;
};

}  // namespace tendon::test
