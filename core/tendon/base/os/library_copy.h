#pragma once

#include <tendon/base/os/file.h>
#include <tendon/base/os/file_content.h>
#include <tendon/base/result.h>

#include <filesystem>
#include <memory>

namespace tendon::os {

/// A private copy of a shared library, which this process loads instead of the original. Therefore
/// a linker, `cp` or an installation can overwrite the original without an effect on running
/// programs. Without the copy, the programs would change or crash, because they would have mapped
/// the overwritten file.
///
/// The copy has the name of its original, so that backtraces, debuggers and profilers show a useful
/// name. It is the file NAME.so in a folder that belongs to this process, below RuntimeFolder().
/// The folder is removed when the process ends. If the process is killed, the next process that
/// makes a copy removes the folder. If files in the folder cannot be executed, or other users can
/// write to the folder, the copy exists only in memory, as /proc/PID/fd/NUMBER.
class LibraryCopy {
 public:
  /// Copies `original`. The error text has no path: the caller puts "PATH: " before it.
  static Result<std::unique_ptr<LibraryCopy>> Make(const std::filesystem::path& original);
  LibraryCopy(const LibraryCopy&) = delete;
  LibraryCopy& operator=(const LibraryCopy&) = delete;
  /// Removes the file, unless Keep() was called. A library that was loaded from the file stays
  /// loaded.
  ~LibraryCopy();

  /// The file to load; other processes of this user can read it as well.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// The content that was copied.
  [[nodiscard]] const FileContent& content() const { return content_; }
  /// Keeps the file until this process ends.
  static void Keep(std::unique_ptr<LibraryCopy> copy);

 private:
  explicit LibraryCopy(int descriptor) : descriptor_(descriptor) {}

  static std::unique_ptr<LibraryCopy> InFolder(const std::filesystem::path& original);
  static std::unique_ptr<LibraryCopy> InMemory(const std::filesystem::path& original);
  Result<void> Fill(const std::filesystem::path& original);

  Descriptor descriptor_;
  std::filesystem::path path_;
  std::filesystem::path folder_;  // private to this copy; empty if the copy is in memory
  FileContent content_;
};

}  // namespace tendon::os
