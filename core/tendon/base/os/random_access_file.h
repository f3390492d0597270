#pragma once

#include <tendon/base/result.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace tendon::os {

/// A file of any size that is read in pieces, at any place. An interface, so that tests and a
/// fuzzer read from memory.
///
/// Thread safety: one thread at a time.
class RandomAccessFile {
 public:
  virtual ~RandomAccessFile() = default;

  /// The path, for messages.
  [[nodiscard]] virtual const std::string& name() const noexcept = 0;
  /// The size when the file was opened, in bytes.
  [[nodiscard]] virtual std::uint64_t size() const noexcept = 0;
  /// Fills `bytes` with the bytes at `offset`. kFailed if the disk reports an error or the file is
  /// shorter: "cannot read 9 bytes at 8 of FILE: Input/output error".
  virtual Result<void> ReadAt(std::uint64_t offset, std::span<std::byte> bytes) = 0;
  /// True if a WritableFile of this machine has the file open. Costs a system call.
  [[nodiscard]] virtual bool is_being_written() const noexcept { return false; }
};

/// A new file that is written in large pieces. An interface, so that tests can have a disk that
/// fails.
///
/// Thread safety: one thread at a time.
class WritableFile {
 public:
  virtual ~WritableFile() = default;

  /// The path, for messages.
  [[nodiscard]] virtual const std::string& name() const noexcept = 0;
  /// Writes the parts one after the other, from `offset` on. kFailed with the system's reason
  /// alone: "No space left on device (0 B free)". Some of the bytes may be in the file then.
  virtual Result<void> WriteAt(std::uint64_t offset,
                               std::span<const std::span<const std::byte>> parts) = 0;
  /// Makes sure that the bytes from `offset` on can be written without a lack of space; the size
  /// of the file remains. Succeeds without effect if the file system has no such function. kFailed
  /// as WriteAt().
  virtual Result<void> Reserve(std::uint64_t offset, std::uint64_t length) = 0;
  /// Cuts the file at `size`, and gives back what is reserved behind it. kFailed as WriteAt().
  virtual Result<void> Truncate(std::uint64_t size) = 0;
  /// Waits until all that was written is on the disk. kFailed as WriteAt(); then some of it may be
  /// lost, and another call does not help.
  virtual Result<void> Sync() = 0;
};

/// Opens a regular file; kNotFound if there is none, kFailed if it cannot be read.
Result<std::unique_ptr<RandomAccessFile>> OpenRandomAccessFile(const std::filesystem::path& file);

/// Creates a file, and locks it until it is closed: is_being_written() shows the lock to readers.
/// kExists if there is a file of this name, which remains as it is; kFailed if it cannot be
/// created.
Result<std::unique_ptr<WritableFile>> CreateWritableFile(const std::filesystem::path& file);

}  // namespace tendon::os
