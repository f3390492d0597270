#pragma once

#include <tendon/base/result.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace tendon::os {

/// Owns a file descriptor and closes it in the destructor. A value below 0 means no descriptor.
class Descriptor {
 public:
  explicit Descriptor(int value) noexcept : value_(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { Close(); }

  [[nodiscard]] int get() const noexcept { return value_; }
  /// Closes the descriptor now. A second call does nothing.
  void Close() noexcept;

 private:
  int value_;
};

/// Makes the name of a file survive a power cut. Ignores errors, because some file systems cannot
/// do it.
void SyncName(const std::filesystem::path& file);

/// Appends `text` to a file, which is created if missing, and waits until the text is on the disk.
Result<void> AppendDurably(const std::filesystem::path& file, std::string_view text);

/// Replaces the content of a file atomically: even after a crash, the file has either all of the
/// old content or all of the new content. An existing file keeps its mode and, if the system allows
/// it, its owner. If the file is a symbolic link, the link stays, and its target is written. Other
/// hard links to the file keep the old content. Waits until the data is on the disk. Returns
/// kFailed if this user may not write the file, if it is not a regular file, or if no file can be
/// created in its folder.
Result<void> ReplaceDurably(const std::filesystem::path& file, std::string_view text);

/// Checks that AppendDurably() and ReplaceDurably() can be expected to succeed: creates and removes
/// a small file in the folder, and checks that an existing file may be written. Waits for the disk.
/// Returns kFailed for the same reasons as ReplaceDurably().
Result<void> CheckWritable(const std::filesystem::path& file);

/// Calls `read` and returns its result. If the file was written meanwhile, calls `read` again, so
/// that the result is never half old and half new. Returns kFailed if the file keeps changing.
Result<std::string> ReadUnchanged(const std::filesystem::path& file,
                                  const std::function<Result<std::string>()>& read);

/// Returns the content of a small file that holds a secret; the file belongs to this user and has
/// mode 0600. If the file is missing, creates it with `content`. If several processes create it at
/// once, one succeeds, and all return the content of that process. Returns kDenied if the file
/// belongs to another user or if others may read it.
Result<std::string> ReadOrMakePrivateFile(const std::filesystem::path& file,
                                          const std::string& content);

}  // namespace tendon::os
