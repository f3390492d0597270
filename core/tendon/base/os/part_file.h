#pragma once

#include <tendon/base/os/file.h>
#include <tendon/base/os/random_access_file.h>
#include <tendon/base/result.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace tendon::os {

/// Long work calls this function repeatedly. If it returns true, the work should stop. May be
/// empty.
using StopRequest = std::function<bool()>;

/// Returns the error for work that was stopped before `file` was complete.
[[nodiscard]] Error StoppedError(const std::filesystem::path& file);

/// A new file, such as `run.h5`. It is written under the name `run.h5.part`, and renamed when it is
/// complete. Therefore, a failure, a full disk or a killed program never leaves a partial file
/// under the final name.
///
/// Thread safety: one thread at a time.
class PartFile {
 public:
  /// Creates the part file. Replaces a part file that a killed program has left. Fails with kExists
  /// if `file` already exists or another program is writing it, and with kFailed if the part file
  /// cannot be created.
  static Result<PartFile> Create(const std::filesystem::path& file);
  PartFile(PartFile&& other) noexcept;
  PartFile& operator=(PartFile&&) = delete;
  /// Removes the part file, unless it was completed.
  ~PartFile();

  /// The name while it is being written.
  [[nodiscard]] const std::filesystem::path& part() const { return part_; }
  /// Returns the empty part file, open for writing. It is locked while it is open, so that another
  /// Create() fails. Call it once.
  [[nodiscard]] std::unique_ptr<WritableFile> TakeFile() { return std::move(opened_); }
  /// Waits until the part file, which must be closed, is on the disk, and renames it. Fails with
  /// kExists like Create(), and with kFailed if the disk fails.
  Result<void> Complete();

 private:
  PartFile(std::filesystem::path file, std::filesystem::path part,
           std::unique_ptr<WritableFile> opened)
      : file_(std::move(file)), part_(std::move(part)), opened_(std::move(opened)) {}

  std::filesystem::path file_;
  std::filesystem::path part_;  // empty after Complete()
  std::unique_ptr<WritableFile> opened_;
};

/// Locks a folder until the result is destroyed. A program that closes part files before they have
/// their final names needs this lock, because other programs replace part files that are not
/// locked. Returns null if another program has the lock. Locks nothing if the file system cannot
/// lock folders, or if the folder may not be read.
[[nodiscard]] std::unique_ptr<Descriptor> LockFolder(const std::filesystem::path& folder);

}  // namespace tendon::os
