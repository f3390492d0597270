#pragma once

#include <tendon/base/os/descriptor.h>
#include <tendon/base/os/loading/file_content.h>
#include <tendon/base/result.h>

#include <filesystem>
#include <memory>

namespace tendon::os {

/// The bytes of a shared library in a file of this process alone, to be loaded instead of the one
/// that they come from: what a linker, `cp` or an installation does to that one changes nothing of
/// what runs. A mapped file that is overwritten in place would change, or end, who runs it.
///
/// The copy has the name of its original, so that backtraces, debuggers and profilers find it under
/// a name that says something: NAME.so in a folder of this process below RuntimeFolder(), which
/// goes when the process ends; what a killed one leaves goes when the next one makes a copy. Where
/// files of that folder cannot be executed, or it is none of ours, the copy is in memory alone:
/// /proc/PID/fd/NUMBER.
class LibraryCopy {
 public:
  /// The error goes on after "PATH: ".
  static Result<std::unique_ptr<LibraryCopy>> Make(const std::filesystem::path& original);
  LibraryCopy(const LibraryCopy&) = delete;
  LibraryCopy& operator=(const LibraryCopy&) = delete;
  /// The file goes, unless it is to be kept. What has been loaded of it stays.
  ~LibraryCopy();

  /// To be loaded; other processes of this user can read it, too.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// What was copied.
  [[nodiscard]] const FileContent& content() const { return content_; }
  /// Keeps the file as long as this process lives.
  static void Keep(std::unique_ptr<LibraryCopy> copy);

 private:
  explicit LibraryCopy(int descriptor) : descriptor_(descriptor) {}

  static std::unique_ptr<LibraryCopy> InFolder(const std::filesystem::path& original);
  static std::unique_ptr<LibraryCopy> InMemory(const std::filesystem::path& original);
  Result<void> Fill(const std::filesystem::path& original);

  Descriptor descriptor_;
  std::filesystem::path path_;
  std::filesystem::path folder_;  // of this copy alone; empty where it is in memory
  FileContent content_;
};

}  // namespace tendon::os
