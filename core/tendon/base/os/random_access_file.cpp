#include <tendon/base/os/random_access_file.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/uio.h>
#include <tendon/base/os/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

namespace tendon::os {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxPartsAtOnce = 8;

std::string SystemReason() { return std::generic_category().message(errno); }

class PosixRandomAccessFile final : public RandomAccessFile {
 public:
  PosixRandomAccessFile(std::string name, int descriptor, std::uint64_t size)
      : name_(std::move(name)), descriptor_(descriptor), size_(size) {}

  [[nodiscard]] const std::string& name() const noexcept override { return name_; }
  [[nodiscard]] std::uint64_t size() const noexcept override { return size_; }

  Result<void> ReadAt(std::uint64_t offset, std::span<std::byte> bytes) override {
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t some = pread(descriptor_.get(), bytes.data() + done, bytes.size() - done,
                                 static_cast<off_t>(offset + done));
      if (some < 0 && errno == EINTR) continue;
      if (some > 0) {
        done += static_cast<std::size_t>(some);
        continue;
      }
      return Error{ErrorCode::kFailed,
                   "cannot read " + std::to_string(bytes.size()) + " bytes at " +
                       std::to_string(offset) + " of " + name_ + ": " +
                       (some < 0 ? SystemReason() : "the file has become shorter")};
    }
    return {};
  }

  [[nodiscard]] bool is_being_written() const noexcept override {
    if (flock(descriptor_.get(), LOCK_SH | LOCK_NB) != 0) return errno == EWOULDBLOCK;
    flock(descriptor_.get(), LOCK_UN);
    return false;
  }

 private:
  const std::string name_;
  const Descriptor descriptor_;
  const std::uint64_t size_;
};

class PosixWritableFile final : public WritableFile {
 public:
  PosixWritableFile(std::string name, int descriptor)
      : name_(std::move(name)), descriptor_(descriptor) {}

  [[nodiscard]] const std::string& name() const noexcept override { return name_; }

  Result<void> WriteAt(std::uint64_t offset,
                       std::span<const std::span<const std::byte>> parts) override {
    std::size_t done = 0;  // bytes of parts.front() that are written
    while (!parts.empty()) {
      std::array<iovec, kMaxPartsAtOnce> pieces{};
      const std::size_t count = std::min(parts.size(), pieces.size());
      for (std::size_t i = 0; i < count; ++i) {
        const auto part = parts[i].subspan(i == 0 ? done : 0);
        pieces[i] = {const_cast<std::byte*>(part.data()), part.size()};
      }
      const ssize_t some = pwritev(descriptor_.get(), pieces.data(), static_cast<int>(count),
                                   static_cast<off_t>(offset));
      if (some < 0 && errno == EINTR) continue;
      if (some < 0) return Failure();
      offset += static_cast<std::uint64_t>(some);
      done += static_cast<std::size_t>(some);
      while (!parts.empty() && done >= parts.front().size()) {
        done -= parts.front().size();
        parts = parts.subspan(1);
      }
    }
    return {};
  }

  Result<void> Reserve(std::uint64_t offset, std::uint64_t length) override {
    const int done = fallocate(descriptor_.get(), FALLOC_FL_KEEP_SIZE, static_cast<off_t>(offset),
                               static_cast<off_t>(length));
    if (done != 0 && (errno == ENOSPC || errno == EDQUOT)) return Failure();
    return {};
  }

  Result<void> Truncate(std::uint64_t size) override {
    if (ftruncate(descriptor_.get(), static_cast<off_t>(size)) != 0) return Failure();
    return {};
  }

  Result<void> Sync() override {
    if (fdatasync(descriptor_.get()) != 0) return Failure();
    return {};
  }

  [[nodiscard]] Identity identity() const noexcept override {
    struct stat status {};
    if (fstat(descriptor_.get(), &status) != 0) return {};
    return {.disk = status.st_dev, .number = status.st_ino};
  }

 private:
  [[nodiscard]] Error Failure() const {
    const int reason = errno;
    std::string text = std::generic_category().message(reason);
    struct statvfs disk {};
    if (reason == ENOSPC && fstatvfs(descriptor_.get(), &disk) == 0) {
      text += " (" + std::to_string(disk.f_bavail * disk.f_frsize) + " B free)";
    }
    return {ErrorCode::kFailed, text};
  }

  const std::string name_;
  const Descriptor descriptor_;
};

/// Takes the lock that is_being_written() checks. Returns false if another program keeps it. A
/// reader that checks it at this moment holds it for a few microseconds, on a busy machine for
/// longer. Network shares may have no locks; their files are not locked.
bool LockForWriting(int file) {
  constexpr int kMaxTries = 100;
  constexpr std::chrono::milliseconds kPause(1);
  for (int i = 0; i < kMaxTries; ++i) {
    if (flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return true;
    std::this_thread::sleep_for(kPause);
  }
  return false;
}

}  // namespace

Result<std::unique_ptr<RandomAccessFile>> OpenRandomAccessFile(const fs::path& file) {
  const int opened = open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (opened < 0) {
    return Error{errno == ENOENT ? ErrorCode::kNotFound : ErrorCode::kFailed,
                 "cannot open " + file.string() + ": " + SystemReason()};
  }
  struct stat status {};
  const bool is_regular = fstat(opened, &status) == 0 && S_ISREG(status.st_mode);
  auto made = std::make_unique<PosixRandomAccessFile>(file.string(), opened,
                                                      static_cast<std::uint64_t>(status.st_size));
  if (!is_regular) {
    return Error{ErrorCode::kFailed, "cannot open " + file.string() + ": it is not a regular file"};
  }
  return std::unique_ptr<RandomAccessFile>(std::move(made));
}

Result<std::unique_ptr<WritableFile>> CreateWritableFile(const fs::path& file) {
  constexpr mode_t kPermissions = 0644;
  const int opened = open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, kPermissions);
  if (opened < 0) {
    return Error{errno == EEXIST ? ErrorCode::kExists : ErrorCode::kFailed,
                 "cannot create " + file.string() + ": " + SystemReason()};
  }
  auto made = std::make_unique<PosixWritableFile>(file.string(), opened);
  LockForWriting(opened);
  SyncName(file);
  return std::unique_ptr<WritableFile>(std::move(made));
}

Result<std::unique_ptr<WritableFile>> ReopenWritableFile(const fs::path& file,
                                                         const WritableFile::Identity& identity,
                                                         std::uint64_t size) {
  const auto failure = [&](const std::string& reason) {
    return Error{ErrorCode::kFailed, "cannot open " + file.string() + " again: " + reason};
  };
  const std::string way_out = ": repeat this in a folder that no other program uses";
  const int opened = open(file.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (opened < 0) return failure(SystemReason());
  auto made = std::make_unique<PosixWritableFile>(file.string(), opened);
  if (!LockForWriting(opened)) return failure("another program is writing it" + way_out);
  struct stat status {};
  if (fstat(opened, &status) != 0) return failure(SystemReason());
  if (made->identity() != identity || !S_ISREG(status.st_mode)) {
    return failure("another program has replaced it" + way_out);
  }
  const auto found = static_cast<std::uint64_t>(status.st_size);
  if (found != size) {
    return failure("another program has changed it, so it has " + std::to_string(found) +
                   " bytes instead of " + std::to_string(size) + way_out);
  }
  return std::unique_ptr<WritableFile>(std::move(made));
}

Result<void> SyncContent(const fs::path& file) {
  const Descriptor opened(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (opened.get() < 0 || fdatasync(opened.get()) != 0) {
    return Error{ErrorCode::kFailed,
                 "cannot write " + file.string() + " to the disk: " + SystemReason()};
  }
  return {};
}

}  // namespace tendon::os
