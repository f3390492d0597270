#pragma once

#include <tendon/base/log.h>
#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/shared_slot_ring.h>

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string_view>
#include <thread>

namespace tendon {

/// A bounded queue for the records that tasks log in their cycles. A separate thread takes the
/// records from the queue and writes them to the log.
///
/// A source may have at most as many records in the queue as the queue has free slots. Therefore, a
/// source that logs too much can fill only half of the queue, and two such sources together can
/// fill two thirds. Further records are lost; the log reports their number.
///
/// Thread safety: any thread may add records; lock-free, without allocation or system call.
class CycleLog final : public LogDeferral {
 public:
  static constexpr std::size_t kCapacity = 512;
  /// The largest size of a message in bytes. A longer message is cut, and ends with "...".
  static constexpr std::size_t kLongest = 224;
  static constexpr std::chrono::milliseconds kDrainInterval{20};
  /// Time between two reports of lost records.
  static constexpr std::chrono::seconds kBetweenReports{1};

  /// The instance that all living tasks share. Not for real-time threads.
  static std::shared_ptr<CycleLog> OfThisProcess();

  CycleLog();
  CycleLog(const CycleLog&) = delete;
  CycleLog& operator=(const CycleLog&) = delete;
  /// Logs all queued records.
  ~CycleLog();

  void Defer(LogTime time, LogLevel level, std::string_view source,
             std::string_view message) noexcept override;

  /// Number of lost records.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_.value(); }

 private:
  struct Record;

  /// Counts the added and the logged records of a source. The difference is the number of queued
  /// records.
  struct SourceCount {
    SharedCounter<> added;
    Counter<> logged;
  };
  /// The number of counts. Several sources may share a count; then they are treated as one source.
  /// This is sufficient, because few tasks log too much.
  static constexpr std::size_t kSourceCounts = 64;

  void Run();
  void Drain();
  bool ReportLost();
  SourceCount& CountOf(std::string_view source) noexcept;

  SharedSlotRing<> ring_;
  std::array<SourceCount, kSourceCounts> source_counts_;
  SharedCounter<> lost_;
  std::uint64_t lost_reported_ = 0;  // the reported part of lost_; used only by the thread
  std::mutex mutex_;
  std::condition_variable stopped_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace tendon
