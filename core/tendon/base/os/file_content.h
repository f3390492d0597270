#pragma once

#include <tendon/base/result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <utility>

namespace tendon::os {

/// Metadata of a file from the file system. Every write to the file changes at least one of these
/// values.
struct FileStamp {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::uint64_t size = 0;
  std::int64_t written = 0;  ///< ns since 1970; a tool may have set it
  /// The last change of bytes, mode or links, ns since 1970; set by the kernel.
  std::int64_t changed = 0;

  bool operator==(const FileStamp&) const = default;
};

/// The bytes of a file at one moment, identified by their hash.
struct FileContent {
  std::filesystem::path file;  ///< absolute
  FileStamp stamp;
  std::array<std::uint64_t, 2> hash{};  ///< XXH3, 128 bits
};

/// Reads a regular file from beginning to end and calls `take`, which may be null, with each part.
/// If the file is written meanwhile, reads it again, so that the content is never half old and half
/// new; `begin` is called before each attempt. The error text has no path: the caller puts "PATH: "
/// before it.
Result<FileContent> ReadContent(
    const std::filesystem::path& file,
    const std::function<Result<void>(std::span<const std::byte>)>& take = nullptr,
    const std::function<Result<void>()>& begin = nullptr);

/// Detects if a file has changed since it was read. Not thread-safe.
class FileWatch {
 public:
  enum class State {
    kSame,   ///< the bytes are the same, even if the file was touched or copied
    kOther,  ///< the bytes are different, or cannot be read
    kGone,
  };

  explicit FileWatch(FileContent content) : content_(std::move(content)), seen_(content_.stamp) {}

  [[nodiscard]] const FileContent& content() const { return content_; }
  /// Compares the file with its content when it was read. Costs a system call. Reads the bytes only
  /// if the stamp has changed since the last call, or if the last write is so recent that another
  /// write may not change the stamp.
  State Check();
  /// Returns the time of the last write to the file that the last Check() found, ns since 1970; 0
  /// if Check() found no file.
  [[nodiscard]] std::int64_t written_now() const {
    return state_ == State::kGone ? 0 : seen_.written;
  }

 private:
  FileContent content_;
  FileStamp seen_;
  bool is_settled_ = false;  // true if every later write changes the stamp
  State state_ = State::kSame;
};

}  // namespace tendon::os
