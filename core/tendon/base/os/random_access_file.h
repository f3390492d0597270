#pragma once

#include <tendon/base/result.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace tendon::os {

/// A file of any size, from which pieces at any offset can be read. This is an interface, so that
/// tests and a fuzzer can read from memory.
///
/// Thread safety: one thread at a time.
class RandomAccessFile {
 public:
  virtual ~RandomAccessFile() = default;

  /// The path, for messages.
  [[nodiscard]] virtual const std::string& name() const noexcept = 0;
  /// The size when the file was opened, in bytes.
  [[nodiscard]] virtual std::uint64_t size() const noexcept = 0;
  /// Fills `bytes` with the bytes at `offset`. Returns kFailed if the disk reports an error or if
  /// the file has become too short: "cannot read 9 bytes at 8 of FILE: Input/output error".
  virtual Result<void> ReadAt(std::uint64_t offset, std::span<std::byte> bytes) = 0;
  /// True if a WritableFile of this machine has the file open. Costs a system call.
  [[nodiscard]] virtual bool is_being_written() const noexcept { return false; }
};

/// A new file that is written in large pieces. This is an interface, so that tests can simulate a
/// disk that fails.
///
/// Thread safety: one thread at a time.
class WritableFile {
 public:
  /// Tells a file from all others, even if they are given its name later.
  struct Identity {
    std::uint64_t disk = 0;
    std::uint64_t number = 0;

    bool operator==(const Identity&) const = default;
  };

  virtual ~WritableFile() = default;

  /// The path, for messages.
  [[nodiscard]] virtual const std::string& name() const noexcept = 0;
  /// Writes the parts one after the other, starting at `offset`. On failure returns kFailed with
  /// only the system's reason: "No space left on device (0 B free)". Then a part of the bytes may
  /// be in the file.
  virtual Result<void> WriteAt(std::uint64_t offset,
                               std::span<const std::span<const std::byte>> parts) = 0;
  /// Reserves disk space for `length` bytes at `offset`, so that writing them cannot fail for lack
  /// of space. Does not change the size of the file. Does nothing, and succeeds, if the file system
  /// cannot reserve space. Fails like WriteAt().
  virtual Result<void> Reserve(std::uint64_t offset, std::uint64_t length) = 0;
  /// Cuts the file to `size` bytes and frees the reserved space after them. Fails like WriteAt().
  virtual Result<void> Truncate(std::uint64_t size) = 0;
  /// Waits until all written data is on the disk. Fails like WriteAt(). After an error, some of the
  /// data may be lost, even if a later call succeeds.
  virtual Result<void> Sync() = 0;
  /// All zero if the file is on no disk.
  [[nodiscard]] virtual Identity identity() const noexcept { return {}; }
};

/// Opens a regular file. Errors: kNotFound if the file does not exist, kFailed if it cannot be
/// read.
Result<std::unique_ptr<RandomAccessFile>> OpenRandomAccessFile(const std::filesystem::path& file);

/// Creates a file and locks it until it is closed; RandomAccessFile::is_being_written() shows the
/// lock to readers. On a disk without locks, such as some network shares, the file is not locked.
/// Errors: kExists if the file exists (it is not changed), kFailed if it cannot be created.
Result<std::unique_ptr<WritableFile>> CreateWritableFile(const std::filesystem::path& file);
/// Opens a file that CreateWritableFile() has created and to which `size` bytes were written, and
/// locks it again. Fails with kFailed if it cannot be opened, if another program has replaced it or
/// changed its size, or if another program is writing it.
Result<std::unique_ptr<WritableFile>> ReopenWritableFile(const std::filesystem::path& file,
                                                         const WritableFile::Identity& identity,
                                                         std::uint64_t size);

/// Waits until the content of a closed file is on the disk. Fails with kFailed if the disk fails.
Result<void> SyncContent(const std::filesystem::path& file);

}  // namespace tendon::os
