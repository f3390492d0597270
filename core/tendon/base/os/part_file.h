#pragma once

#include <tendon/base/os/random_access_file.h>
#include <tendon/base/result.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace tendon::os {

/// Asked again and again by long work: true means that it should stop. May be empty.
using StopRequest = std::function<bool()>;

/// The error of work that was stopped. `file` is what it would have written.
[[nodiscard]] Error StoppedError(const std::filesystem::path& file);

/// A new file `run.h5` that is written as `run.h5.part`, and gets its name when it is complete. So
/// a failure, a full disk or a killed program never leaves a half file under the final name.
///
/// Thread safety: one thread at a time.
class PartFile {
 public:
  /// Creates the part. kExists if `file` is there already, or another program is writing it.
  /// Replaces what a killed program has left of the part. kFailed if it cannot be created.
  static Result<PartFile> Create(const std::filesystem::path& file);
  PartFile(PartFile&& other) noexcept;
  PartFile& operator=(PartFile&&) = delete;
  /// Removes the part, unless it was completed.
  ~PartFile();

  /// The name while it is being written.
  [[nodiscard]] const std::filesystem::path& part() const { return part_; }
  /// The empty part, to write into. While it is open, it is locked, so that another Create() sees
  /// that it is being written. Once.
  [[nodiscard]] std::unique_ptr<WritableFile> TakeFile() { return std::move(opened_); }
  /// Waits until the part, which must be closed, is on the disk, and gives the file its name.
  /// kExists as Create(), kFailed if the disk fails.
  Result<void> Complete();

 private:
  PartFile(std::filesystem::path file, std::filesystem::path part,
           std::unique_ptr<WritableFile> opened)
      : file_(std::move(file)), part_(std::move(part)), opened_(std::move(opened)) {}

  std::filesystem::path file_;
  std::filesystem::path part_;  // empty after Complete()
  std::unique_ptr<WritableFile> opened_;
};

}  // namespace tendon::os
