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

/// Appends `text` to a file, which is created if missing, and waits until it is on the disk.
Result<void> AppendDurably(const std::filesystem::path& file, std::string_view text);

/// Replaces the content of a file atomically: even after a crash, it has all of the old or all of
/// the new content. An existing file keeps its mode and, if the system allows it, its owner. A
/// symbolic link stays a link, and its target is written; further hard links keep the old content.
/// Waits until the data is on the disk. kFailed if this user may not write the file, it is not
/// regular, or its folder accepts no other file.
Result<void> ReplaceDurably(const std::filesystem::path& file, std::string_view text);

/// Checks that both functions above can be expected to succeed: creates and removes a small file in
/// the folder, and checks that an existing file may be written. Waits for the disk; kFailed as
/// above.
Result<void> CheckWritable(const std::filesystem::path& file);

/// Calls `read` and returns its result. Calls it again if the file was written meanwhile, so that
/// the result is never half old and half new; kFailed if the file keeps changing.
Result<std::string> ReadUnchanged(const std::filesystem::path& file,
                                  const std::function<Result<std::string>()>& read);

/// Returns the content of a small file of this user, mode 0600, that holds a secret. If it is
/// missing, creates it with `content`; if several processes create it at once, one wins and all
/// return its content. kDenied if it belongs to another user or others may read it.
Result<std::string> ReadOrMakePrivateFile(const std::filesystem::path& file,
                                          const std::string& content);

}  // namespace tendon::os
