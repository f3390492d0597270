#include <tendon/base/os/file_content.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <tendon/base/os/file.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <memory>
#include <optional>
#include <system_error>
#include <vector>

namespace tendon::os {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBytesAtOnce = std::size_t{1} << 20U;  // bytes

Error CannotRead() {
  const std::error_code reason(errno, std::generic_category());
  return {ErrorCode::kFailed, "cannot be read: " + reason.message()};
}

std::int64_t SinceEpoch(const timespec& time) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  return time.tv_sec * kSecond + time.tv_nsec;
}

FileStamp FileStampOf(const struct stat& status) {
  return {.device = status.st_dev,
          .inode = status.st_ino,
          .size = static_cast<std::uint64_t>(status.st_size),
          .written = SinceEpoch(status.st_mtim),
          .changed = SinceEpoch(status.st_ctim)};
}

/// The stamp of an open file; empty if it is not a regular file.
std::optional<FileStamp> FileStampOf(int descriptor) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return FileStampOf(status);
}

/// Returns the stamp of a file; empty if there is no such file.
std::optional<FileStamp> FileStampOf(const fs::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) return std::nullopt;
  return FileStampOf(status);
}

/// True if the file was changed so long ago that the next change will have a different time. The
/// kernel's file times advance only in steps of a few milliseconds.
bool IsSettled(const FileStamp& stamp) {
  constexpr std::chrono::milliseconds kLongestStep(100);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::abs(now - std::chrono::nanoseconds(stamp.changed)) > kLongestStep;
}

/// Returns the hash of the first `size` bytes, or of all bytes if there are fewer. Without this
/// limit, the loop would not end for a file that grows as fast as it is read.
Result<std::array<std::uint64_t, 2>> ReadBytes(
    int descriptor, std::uint64_t size,
    const std::function<Result<void>(std::span<const std::byte>)>& take) {
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> hash(XXH3_createState(),
                                                                      &XXH3_freeState);
  if (hash == nullptr)
    return Error{ErrorCode::kFailed, "there is not enough memory to read the file"};
  XXH3_128bits_reset(hash.get());
  std::vector<std::byte> part(kBytesAtOnce);
  while (size > 0) {
    const auto most = static_cast<std::size_t>(std::min<std::uint64_t>(size, part.size()));
    const ssize_t some = read(descriptor, part.data(), most);
    if (some < 0 && errno == EINTR) continue;
    if (some < 0) return CannotRead();
    if (some == 0) break;
    const std::span<const std::byte> bytes(part.data(), static_cast<std::size_t>(some));
    size -= bytes.size();
    XXH3_128bits_update(hash.get(), bytes.data(), bytes.size());
    if (!take) continue;
    if (auto taken = take(bytes); !taken) return taken.error();
  }
  const XXH128_hash_t digest = XXH3_128bits_digest(hash.get());
  return std::array<std::uint64_t, 2>{digest.high64, digest.low64};
}

}  // namespace

Result<FileContent> ReadContent(const fs::path& file,
                                const std::function<Result<void>(std::span<const std::byte>)>& take,
                                const std::function<Result<void>()>& begin) {
  constexpr int kMaxTries = 10;
  for (int i = 0; i < kMaxTries; ++i) {
    if (begin) {
      if (auto begun = begin(); !begun) return begun.error();
    }
    const Descriptor opened(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (opened.get() < 0) return CannotRead();
    const auto before = FileStampOf(opened.get());
    if (!before) return Error{ErrorCode::kFailed, "is not a regular file"};
    const auto hash = ReadBytes(opened.get(), before->size, take);
    if (!hash) return hash.error();
    if (FileStampOf(opened.get()) != before || FileStampOf(file) != before) continue;
    std::error_code ignored;
    return FileContent{.file = fs::absolute(file, ignored), .stamp = *before, .hash = *hash};
  }
  return Error{ErrorCode::kFailed,
               "changes while it is read; try again when the file is completely written"};
}

FileWatch::State FileWatch::Check() {
  const auto now = FileStampOf(content_.file);
  if (!now) return state_ = State::kGone;
  if (*now == seen_ && is_settled_ && state_ != State::kGone) return state_;
  const bool was_settled = IsSettled(*now);
  const auto read = ReadContent(content_.file);
  seen_ = read ? read->stamp : *now;
  is_settled_ = was_settled && seen_ == *now;
  return state_ = read && read->hash == content_.hash ? State::kSame : State::kOther;
}

}  // namespace tendon::os
