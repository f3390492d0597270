#include <tendon/base/os/file.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <tendon/base/os/process.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <optional>
#include <string>
#include <system_error>

namespace tendon::os {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kMode = 0644;

Error Failure(const fs::path& file) {
  const std::error_code reason(errno, std::generic_category());
  return {ErrorCode::kFailed, "cannot write " + file.string() + ": " + reason.message()};
}

/// Writes all of `text` and waits until it is on the disk. On failure, errno has the reason.
bool WriteAll(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return fsync(descriptor) == 0;
}

/// Follows symbolic links and returns their target, which may be missing.
Result<fs::path> TargetOf(const fs::path& file) {
  constexpr int kMaxLinks = 40;
  fs::path target = file;
  for (int links = 0; links < kMaxLinks; ++links) {
    std::error_code reason;
    if (!fs::is_symlink(fs::symlink_status(target, reason))) return target;
    const fs::path next = fs::read_symlink(target, reason);
    if (reason) break;
    target = target.parent_path() / next;
  }
  errno = ELOOP;
  return Failure(file);
}

/// A new file with an unused name, in the folder of the target file. The destructor removes the new
/// file, unless it has replaced the target.
class NextFile {
 public:
  /// Creates the file with `mode`, minus the umask. On failure descriptor() is below 0, and errno
  /// has the reason.
  NextFile(const fs::path& target, mode_t mode) : descriptor_(Make(target, mode)) {}
  NextFile(const NextFile&) = delete;
  NextFile& operator=(const NextFile&) = delete;
  ~NextFile() {
    std::error_code ignored;
    if (descriptor() >= 0 && !path_.empty()) fs::remove(path_, ignored);
  }

  [[nodiscard]] int descriptor() const { return descriptor_.get(); }

  bool TakePlaceOf(const fs::path& target) {
    if (rename(path_.c_str(), target.c_str()) != 0) return false;
    path_.clear();
    return true;
  }

 private:
  int Make(const fs::path& target, mode_t mode) {
    constexpr int kMaxTries = 100;  // killed processes may have left files
    const std::string begin = ".saving-" + std::to_string(getpid()) + "-";
    int made = -1;
    for (int i = 0; i < kMaxTries && made < 0; ++i) {
      path_ = target.parent_path() / (begin + std::to_string(i));
      made = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
      if (made < 0 && errno != EEXIST) break;
    }
    return made;
  }

  fs::path path_;  // declared before descriptor_, whose initialiser fills it
  const Descriptor descriptor_;
};

/// Gives the new file the mode and, if the system allows it, the owner of the replaced file.
bool TakeOver(int descriptor, const struct stat& before) {
  const bool keeps_group = fchown(descriptor, static_cast<uid_t>(-1), before.st_gid) == 0;
  const bool keeps_owner = fchown(descriptor, before.st_uid, static_cast<gid_t>(-1)) == 0;
  mode_t kept = 07777;
  if (!keeps_owner || !keeps_group) kept = 0777;  // set-id bits must not give rights to others
  if (!keeps_group) kept &= ~static_cast<mode_t>(S_IRWXG);
  return fchmod(descriptor, before.st_mode & kept) == 0;
}

/// The size and the time of the last write, to detect that a file has changed.
struct Stamp {
  std::uintmax_t size = 0;
  fs::file_time_type written;

  bool operator==(const Stamp&) const = default;
};

Stamp StampOf(const fs::path& file) {
  std::error_code ignored;  // a missing file has a different stamp
  return {fs::file_size(file, ignored), fs::last_write_time(file, ignored)};
}

Error Denied(const std::filesystem::path& file, int reason) {
  return {ErrorCode::kDenied,
          file.string() + ": " + std::error_code(reason, std::generic_category()).message()};
}

/// Reads a private file. Returns nothing if there is no such file.
std::optional<Result<std::string>> Read(const std::filesystem::path& file) {
  const Descriptor descriptor(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
  if (descriptor.get() < 0) {
    if (errno == ENOENT) return std::nullopt;
    return Denied(file, errno);
  }
  struct stat status {};
  if (fstat(descriptor.get(), &status) != 0) return Denied(file, errno);
  if (status.st_uid != geteuid() || (status.st_mode & 077U) != 0 || !S_ISREG(status.st_mode)) {
    return Error{ErrorCode::kDenied,
                 file.string() +
                     " must belong to your user, and only your user may read it (mode 0600): "
                     "remove this file, then start the program again"};
  }
  std::array<char, 256> content{};
  const auto size = read(descriptor.get(), content.data(), content.size());
  if (size < 0) return Denied(file, errno);
  return std::string(content.data(), static_cast<std::size_t>(size));
}

}  // namespace

void Descriptor::Close() noexcept {
  if (value_ >= 0) close(value_);
  value_ = -1;
}

void SyncName(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const Descriptor descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.get() >= 0) static_cast<void>(fsync(descriptor.get()));
}

Result<void> AppendDurably(const fs::path& file, std::string_view text) {
  const Descriptor descriptor(open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, kMode));
  if (descriptor.get() < 0 || !WriteAll(descriptor.get(), text)) return Failure(file);
  return {};
}

Result<void> ReplaceDurably(const fs::path& file, std::string_view text) {
  const auto target = TargetOf(file);
  if (!target) return target.error();
  struct stat before = {};
  const bool is_there = stat(target->c_str(), &before) == 0;
  if (is_there && !S_ISREG(before.st_mode)) {
    return Error{ErrorCode::kFailed,
                 "cannot write " + file.string() + ": it is not a regular file"};
  }
  if (is_there && faccessat(AT_FDCWD, target->c_str(), W_OK, AT_EACCESS) != 0) {
    return Failure(file);
  }
  constexpr mode_t kPermissions = 0777;
  NextFile next(*target, is_there ? before.st_mode & kPermissions : kMode);
  if (next.descriptor() < 0) return Failure(file);
  if (is_there && !TakeOver(next.descriptor(), before)) return Failure(file);
  if (!WriteAll(next.descriptor(), text) || !next.TakePlaceOf(*target)) return Failure(file);
  SyncName(*target);
  return {};
}

Result<void> CheckWritable(const fs::path& file) {
  const auto target = TargetOf(file);
  if (!target) return target.error();
  const bool may_write = faccessat(AT_FDCWD, target->c_str(), W_OK, AT_EACCESS) == 0;
  if (!may_write && errno != ENOENT) return Failure(file);
  const NextFile probe(*target, kMode);
  if (probe.descriptor() < 0 || !WriteAll(probe.descriptor(), "probe\n")) return Failure(file);
  return {};
}

Result<std::string> ReadUnchanged(const fs::path& file,
                                  const std::function<Result<std::string>()>& read) {
  constexpr int kMaxTries = 10;
  for (int i = 0; i < kMaxTries; ++i) {
    const Stamp before = StampOf(file);
    auto text = read();
    if (StampOf(file) == before) return text;
  }
  return Error{
      ErrorCode::kFailed,
      file.string() +
          ": the file changes while it is read; try again when the file is completely written"};
}

Result<std::string> ReadOrMakePrivateFile(const std::filesystem::path& file,
                                          const std::string& content) {
  if (auto found = Read(file)) return *std::move(found);

  // Writes the content under another name and then links it, so that no reader ever sees a partial
  // file.
  const std::filesystem::path draft = file.string() + "." + std::to_string(RandomNumber());
  {
    const Descriptor descriptor(open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
    if (descriptor.get() < 0) return Denied(draft, errno);
    const auto written = write(descriptor.get(), content.data(), content.size());
    if (written != static_cast<ssize_t>(content.size())) {
      unlink(draft.c_str());
      return Denied(draft, ENOSPC);
    }
  }
  const int failure = link(draft.c_str(), file.c_str()) == 0 ? 0 : errno;
  unlink(draft.c_str());
  if (failure != 0 && failure != EEXIST) return Denied(file, failure);
  if (auto found = Read(file)) return *std::move(found);
  return Denied(file, ENOENT);
}

}  // namespace tendon::os
