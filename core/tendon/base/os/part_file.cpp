#include <tendon/base/os/part_file.h>

#include <fcntl.h>
#include <sys/file.h>
#include <tendon/base/os/file.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace tendon::os {

Error StoppedError(const std::filesystem::path& file) {
  return {ErrorCode::kFailed,
          "stopped before " + file.string() + " was complete; no file was written"};
}

PartFile::PartFile(PartFile&& other) noexcept
    : file_(std::move(other.file_)),
      part_(std::exchange(other.part_, {})),
      opened_(std::move(other.opened_)) {}

Result<PartFile> PartFile::Create(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::exists(std::filesystem::symlink_status(file, ignored))) {
    return Error{ErrorCode::kExists, file.string() +
                                         " already exists, and no file is replaced: choose another "
                                         "name, or remove the file first"};
  }
  std::filesystem::path part = file;
  part += ".part";
  if (std::filesystem::exists(part, ignored)) {
    const auto left = OpenRandomAccessFile(part);
    if (!left) return left.error();
    if ((*left)->is_being_written()) {
      return Error{ErrorCode::kExists, "another program is writing " + part.string() +
                                           ": wait for its end, or choose another name"};
    }
    std::filesystem::remove(part, ignored);
  }
  auto opened = CreateWritableFile(part);
  if (!opened) return opened.error();
  return PartFile(file, std::move(part), *std::move(opened));
}

PartFile::~PartFile() {
  std::error_code ignored;
  if (!part_.empty()) std::filesystem::remove(part_, ignored);
}

Result<void> PartFile::Complete() {
  std::error_code failed;
  if (std::filesystem::exists(file_, failed)) {
    return Error{ErrorCode::kExists,
                 file_.string() +
                     " was created by another program in the meantime, and no file is replaced: "
                     "choose another name"};
  }
  // Otherwise, a power cut could leave an empty file under the final name.
  if (auto synced = SyncContent(part_); !synced) return synced;
  std::filesystem::rename(part_, file_, failed);
  if (failed) {
    return Error{ErrorCode::kFailed, "cannot rename " + part_.string() + " to " + file_.string() +
                                         ": " + failed.message()};
  }
  part_.clear();
  SyncName(file_);
  return {};
}

std::unique_ptr<Descriptor> LockFolder(const std::filesystem::path& folder) {
  auto opened =
      std::make_unique<Descriptor>(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  const bool is_refused = flock(opened->get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  return is_refused ? nullptr : std::move(opened);
}

}  // namespace tendon::os
