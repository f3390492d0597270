#include <tendon/base/os/library_copy.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <tendon/base/os/process.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace tendon::os {
namespace {

namespace fs = std::filesystem;

Error CannotCopy() {
  const std::error_code reason(errno, std::generic_category());
  return {ErrorCode::kFailed, "cannot be copied for loading: " + reason.message()};
}

/// True if only this user can create files in this folder, so that we can trust and execute them.
bool IsOurs(const fs::path& folder) {
  constexpr mode_t kOthers = S_IWGRP | S_IWOTH;
  struct stat status {};
  return lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) &&
         status.st_uid == geteuid() && (status.st_mode & kOthers) == 0;
}

bool AllowsExecution(const fs::path& folder) {
  struct statvfs system {};
  return statvfs(folder.c_str(), &system) == 0 && (system.f_flag & ST_NOEXEC) == 0;
}

bool IsMade(const fs::path& folder) {
  constexpr mode_t kOurs = 0700;
  return mkdir(folder.c_str(), kOurs) == 0 || errno == EEXIST;
}

/// Returns a name such as "4711-52". 4711 is the process number, and 52 is a random number, because
/// processes in different containers may have the same process number.
std::string NameOfFolder() {
  constexpr std::uint64_t kFew = 1000;
  return std::to_string(ProcessId()) + "-" + std::to_string(RandomNumber() % kFew);
}

/// Locks a folder for the life of this process; the lock also works between containers. Returns
/// null if another process holds the lock, or if the folder is gone.
std::unique_ptr<Descriptor> Lock(const fs::path& folder) {
  auto lock = std::make_unique<Descriptor>(
      open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (lock->get() < 0 || flock(lock->get(), LOCK_EX | LOCK_NB) != 0) return nullptr;
  struct stat held {};
  struct stat there {};
  const bool is_there = fstat(lock->get(), &held) == 0 && lstat(folder.c_str(), &there) == 0 &&
                        held.st_dev == there.st_dev && held.st_ino == there.st_ino;
  return is_there ? std::move(lock) : nullptr;
}

/// The folder of this process. It is locked, and it is removed at the end of the process.
class ProcessFolder {
 public:
  ProcessFolder() {
    const fs::path runtime = RuntimeFolder();
    const fs::path all = runtime / "plugins";
    if (!IsOurs(runtime) || !IsMade(all) || !IsOurs(all) || !AllowsExecution(all)) return;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(all, ignored)) {
      if (const auto left_behind = Lock(entry.path())) fs::remove_all(entry.path(), ignored);
    }
    constexpr int kTimes = 10;
    for (int i = 0; i < kTimes && path_.empty(); ++i) TakeFolder(all / NameOfFolder());
  }
  ProcessFolder(const ProcessFolder&) = delete;
  ProcessFolder& operator=(const ProcessFolder&) = delete;
  /// A forked child shares the folder, and must not remove it.
  ~ProcessFolder() {
    std::error_code ignored;
    if (!path_.empty() && process_ == ProcessId()) fs::remove_all(path_, ignored);
  }

  /// Creates a subfolder. Returns an empty path on failure.
  fs::path MakeFolder() {
    const std::scoped_lock lock(mutex_);
    const fs::path made = path_ / std::to_string(++made_);
    return !path_.empty() && mkdir(made.c_str(), S_IRWXU) == 0 ? made : fs::path();
  }

 private:
  /// Creates and locks the folder. Leaves path_ empty if another process has removed the folder as
  /// abandoned before this process could lock it.
  void TakeFolder(const fs::path& folder) {
    if (mkdir(folder.c_str(), S_IRWXU) != 0) return;
    lock_ = Lock(folder);
    if (lock_) path_ = folder;
  }

  const std::int64_t process_ = ProcessId();
  std::unique_ptr<Descriptor> lock_;
  fs::path path_;
  std::mutex mutex_;
  int made_ = 0;
};

ProcessFolder& OwnFolder() {
  static ProcessFolder folder;
  return folder;
}

Result<void> WritePart(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return CannotCopy();
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return {};
}

}  // namespace

Result<std::unique_ptr<LibraryCopy>> LibraryCopy::Make(const fs::path& original) {
  auto copy = InFolder(original);
  if (copy) {
    if (const auto filled = copy->Fill(original)) {
      copy->descriptor_.Close();
      return copy;
    }
    copy.reset();  // the disk may be full: try memory instead
  }
  copy = InMemory(original);
  if (!copy) return CannotCopy();
  if (auto filled = copy->Fill(original); !filled) return filled.error();
  constexpr int kForGood = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL;
  if (fcntl(copy->descriptor_.get(), F_ADD_SEALS, kForGood) != 0) {
    return CannotCopy();
  }
  return copy;
}

LibraryCopy::~LibraryCopy() {
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

void LibraryCopy::Keep(std::unique_ptr<LibraryCopy> copy) {
  copy->folder_.clear();
  static std::mutex mutex;
  static auto& kept = *new std::vector<std::unique_ptr<LibraryCopy>>();  // never destroyed
  const std::scoped_lock lock(mutex);
  kept.push_back(std::move(copy));
}

/// Creates the copy in the folder of this process. Returns null if there is no usable folder.
std::unique_ptr<LibraryCopy> LibraryCopy::InFolder(const fs::path& original) {
  constexpr mode_t kOurs = S_IRUSR | S_IXUSR;
  const fs::path folder = OwnFolder().MakeFolder();
  if (folder.empty()) return nullptr;
  const fs::path path = folder / original.filename();
  std::unique_ptr<LibraryCopy> copy(new LibraryCopy(
      open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kOurs)));
  copy->folder_ = folder;
  copy->path_ = path;
  return copy->descriptor_.get() >= 0 ? std::move(copy) : nullptr;
}

std::unique_ptr<LibraryCopy> LibraryCopy::InMemory(const fs::path& original) {
  const std::string name = original.filename().string();
  const int made = memfd_create(name.c_str(), MFD_CLOEXEC | MFD_ALLOW_SEALING);
  if (made < 0) return nullptr;
  std::unique_ptr<LibraryCopy> copy(new LibraryCopy(made));
  copy->path_ =
      "/proc/" + std::to_string(ProcessId()) + "/fd/" + std::to_string(copy->descriptor_.get());
  return copy;
}

Result<void> LibraryCopy::Fill(const fs::path& original) {
  const int descriptor = descriptor_.get();
  const auto empty = [descriptor]() -> Result<void> {
    const bool is_empty = ftruncate(descriptor, 0) == 0 && lseek(descriptor, 0, SEEK_SET) == 0;
    return is_empty ? Result<void>() : CannotCopy();
  };
  auto content = ReadContent(
      original,
      [descriptor](std::span<const std::byte> bytes) { return WritePart(descriptor, bytes); },
      empty);
  if (!content) return content.error();
  content_ = *std::move(content);
  return {};
}

}  // namespace tendon::os
