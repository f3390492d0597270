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

/// Holds the records that tasks log in their cycles: a bounded queue, which its own thread empties
/// into the log. A source may not have more waiting records than there are free places. So one
/// source that floods the queue leaves half of it to the others, and two leave a third. A record
/// without a place is lost and counted; the log reports how many.
///
/// Thread safety: any thread may add records; lock-free, without allocation or system call.
class CycleLog final : public LogDeferral {
 public:
  static constexpr std::size_t kCapacity = 512;
  /// Bytes of a message that are kept; "..." replaces the rest.
  static constexpr std::size_t kLongest = 224;
  static constexpr std::chrono::milliseconds kBetweenLooks{20};
  static constexpr std::chrono::seconds kBetweenTellings{1};  ///< of lost records

  /// The instance that all living tasks share. Not for real-time threads.
  static std::shared_ptr<CycleLog> OfThisProcess();

  CycleLog();
  CycleLog(const CycleLog&) = delete;
  CycleLog& operator=(const CycleLog&) = delete;
  /// Logs the waiting records.
  ~CycleLog();

  void PutAside(LogTime time, LogLevel level, std::string_view source,
                std::string_view message) noexcept override;

  /// Records that found no place.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_.value(); }

 private:
  struct Record;

  /// Records of some sources that were added, and that were logged: the difference waits.
  struct Share {
    SharedCounter<> come;
    Counter<> gone;
  };
  /// Sources in one share count as one; there are more shares than tasks that flood.
  static constexpr std::size_t kShares = 64;

  void Run();
  void Drain();
  bool TellLost();
  Share& ShareOf(std::string_view source) noexcept;

  SharedSlotRing<> ring_;
  std::array<Share, kShares> shares_;
  SharedCounter<> lost_;
  std::uint64_t lost_told_ = 0;  // used by the thread
  std::mutex mutex_;
  std::condition_variable stopped_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace tendon
