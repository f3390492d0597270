#pragma once

#include <tendon/base/result.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <utility>

namespace tendon::os {

/// What the file system says of a file. Nobody writes to the file without changing one of these.
struct FileStamp {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::uint64_t size = 0;
  std::int64_t written = 0;  ///< ns since 1970; a tool may have set it
  std::int64_t changed = 0;  ///< the same of its bytes, its mode or its links; set by the kernel

  bool operator==(const FileStamp&) const = default;
};

/// The bytes that a file had at one moment, known by their hash.
struct FileContent {
  std::filesystem::path file;  ///< absolute
  FileStamp stamp;
  std::array<std::uint64_t, 2> hash{};  ///< XXH3, 128 bits
};

/// Reads a regular file from its begin to its end and calls `take` with each part; that may be
/// null. Whoever writes the file meanwhile makes it be read again, for nobody wants half of the old
/// and half of the new; `begin` is called before each attempt. The error goes on after "PATH: ".
Result<FileContent> ReadContent(
    const std::filesystem::path& file,
    const std::function<Result<void>(std::span<const std::byte>)>& take = nullptr,
    const std::function<Result<void>()>& begin = nullptr);

/// Tells what has become of a file since it was read. Not thread-safe.
class FileWatch {
 public:
  enum class State {
    kSame,   ///< has the same bytes, also where somebody has touched or copied it
    kOther,  ///< has other bytes, or cannot be read
    kGone,
  };

  explicit FileWatch(FileContent content) : content_(std::move(content)), seen_(content_.stamp) {}

  [[nodiscard]] const FileContent& content() const { return content_; }
  /// Costs a call of the kernel. The bytes are read only where the stamp is another than at the
  /// last look, or so young that a second write may have left it as it is.
  State Look();
  /// When the file that is there was written, ns since 1970; 0 where there was none at the last
  /// look.
  [[nodiscard]] std::int64_t written_now() const {
    return state_ == State::kGone ? 0 : seen_.written;
  }

 private:
  FileContent content_;
  FileStamp seen_;
  bool is_settled_ = false;  // each write from now on shows in the stamp
  State state_ = State::kSame;
};

}  // namespace tendon::os
