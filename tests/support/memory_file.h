#pragma once

#include <tendon/base/os/random_access_file.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tendon::test {

/// A file in memory for reading. Counts the bytes that were read, and can have an unreadable range.
class MemoryFile final : public os::RandomAccessFile {
 public:
  struct Reads {
    std::uint64_t bytes = 0;
    std::uint64_t bad_begin = 0;  ///< the disk reports an error from this position ...
    std::uint64_t bad_end = 0;    ///< ... to this position
  };

  explicit MemoryFile(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {}
  MemoryFile(std::span<const std::byte> bytes, std::shared_ptr<Reads> reads)
      : bytes_(bytes.begin(), bytes.end()), reads_(std::move(reads)) {}

  [[nodiscard]] const std::string& name() const noexcept override { return name_; }
  [[nodiscard]] std::uint64_t size() const noexcept override { return bytes_.size(); }
  Result<void> ReadAt(std::uint64_t offset, std::span<std::byte> bytes) override {
    if (offset > bytes_.size() || bytes.size() > bytes_.size() - offset) {
      return Error{ErrorCode::kFailed, "cannot read: the file has become shorter"};
    }
    if (offset < reads_->bad_end && offset + bytes.size() > reads_->bad_begin) {
      return Error{ErrorCode::kFailed, "cannot read: Input/output error"};
    }
    reads_->bytes += bytes.size();
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(offset), bytes.size(), bytes.begin());
    return {};
  }

 private:
  const std::string name_ = "memory.mcap";
  const std::vector<std::byte> bytes_;
  const std::shared_ptr<Reads> reads_ = std::make_shared<Reads>();
};

/// A disk in memory on which one file is written. The disk can be full, or can fail.
struct MemoryDisk {
  std::vector<std::byte> bytes;
  std::vector<std::byte> synced;  ///< the bytes after the last sync, which a power cut leaves
  std::uint64_t capacity = std::numeric_limits<std::uint64_t>::max();
  bool can_reserve = true;
  bool can_sync = true;
  std::size_t syncs = 0;
};

class MemoryWritableFile final : public os::WritableFile {
 public:
  explicit MemoryWritableFile(std::shared_ptr<MemoryDisk> disk) : disk_(std::move(disk)) {}

  [[nodiscard]] const std::string& name() const noexcept override { return name_; }
  Result<void> WriteAt(std::uint64_t offset,
                       std::span<const std::span<const std::byte>> parts) override {
    for (const auto part : parts) {
      for (const std::byte byte : part) {
        if (offset >= disk_->capacity) return Full();
        if (offset >= disk_->bytes.size()) disk_->bytes.resize(offset + 1);
        disk_->bytes[offset++] = byte;
      }
    }
    return {};
  }
  Result<void> Reserve(std::uint64_t offset, std::uint64_t length) override {
    if (disk_->can_reserve && offset + length > disk_->capacity) return Full();
    return {};
  }
  Result<void> Truncate(std::uint64_t size) override {
    disk_->bytes.resize(size);
    return {};
  }
  Result<void> Sync() override {
    if (!disk_->can_sync) return Error{ErrorCode::kFailed, "Input/output error"};
    disk_->synced = disk_->bytes;
    ++disk_->syncs;
    return {};
  }

 private:
  static Error Full() { return {ErrorCode::kFailed, "No space left on device (0 B free)"}; }

  const std::string name_ = "memory.mcap";
  const std::shared_ptr<MemoryDisk> disk_;
};

}  // namespace tendon::test
