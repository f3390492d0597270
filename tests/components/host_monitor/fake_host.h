#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "support/folder.h"

namespace tendon_test {

/// A folder that looks like the root of a machine; a test writes the contents of its files.
class FakeHost {
 public:
  [[nodiscard]] const std::filesystem::path& root() const { return folder_.path(); }
  void Write(const std::filesystem::path& file, std::string_view text) {
    std::filesystem::create_directories((root() / file).parent_path());
    std::ofstream(root() / file) << text;
  }
  void Remove(const std::filesystem::path& file) { std::filesystem::remove(root() / file); }

 private:
  tendon::test::Folder folder_;
};

}  // namespace tendon_test
