#pragma once

#include <tendon/base/log.h>
#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/shared_slot_ring.h>

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string_view>
#include <thread>

namespace tendon {

/// Holds the records that tasks log in their cycles: a bounded queue, which a thread of its own
/// empties into the log. A source may not have more waiting records than the queue has free slots.
/// So one source that floods the queue leaves half of it to the others, and two leave a third.
/// Records that are refused are lost; the log reports their number.
///
/// Thread safety: any thread may add records; lock-free, without allocation or system call.
class CycleLog final : public LogDeferral {
 public:
  static constexpr std::size_t kCapacity = 512;
  /// Bytes of a message that are kept; "..." replaces the rest.
  static constexpr std::size_t kLongest = 224;
  static constexpr std::chrono::milliseconds kDrainInterval{20};
  static constexpr std::chrono::seconds kBetweenReports{1};  ///< between reports of losses

  /// The instance that all living tasks share. Not for real-time threads.
  static std::shared_ptr<CycleLog> OfThisProcess();

  CycleLog();
  CycleLog(const CycleLog&) = delete;
  CycleLog& operator=(const CycleLog&) = delete;
  /// Logs the waiting records.
  ~CycleLog();

  void Defer(LogTime time, LogLevel level, std::string_view source,
             std::string_view message) noexcept override;

  /// Number of lost records.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_.value(); }

 private:
  struct Record;

  /// Counts the added and the logged records of some sources; the difference is waiting.
  struct SourceCount {
    SharedCounter<> added;
    Counter<> logged;
  };
  /// Sources with the same count are treated as one source; few tasks flood, so this suffices.
  static constexpr std::size_t kSourceCounts = 64;

  void Run();
  void Drain();
  bool ReportLost();
  SourceCount& CountOf(std::string_view source) noexcept;

  SharedSlotRing<> ring_;
  std::array<SourceCount, kSourceCounts> source_counts_;
  SharedCounter<> lost_;
  std::uint64_t lost_reported_ = 0;  // lost records already reported; used by the thread
  std::mutex mutex_;
  std::condition_variable stopped_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace tendon
