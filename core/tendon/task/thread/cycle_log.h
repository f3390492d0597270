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

/// Where the records wait that tasks log in their cycles: a bounded queue, which a thread of its
/// own empties into the log. No source may have more records waiting than there are free places, so
/// that one that floods it leaves half to the others, and two leave a third. What finds no place is
/// lost, and counted: the log says how many.
///
/// Thread safety: any threads put records aside; lock-free, without allocation or system call.
class CycleLog final : public LogDeferral {
 public:
  static constexpr std::size_t kCapacity = 512;
  /// Bytes of a message that are kept; "..." stands for the others.
  static constexpr std::size_t kLongest = 224;
  static constexpr std::chrono::milliseconds kBetweenLooks{20};
  static constexpr std::chrono::seconds kBetweenTellings{1};  ///< of what is lost

  /// The one of all tasks that live. Not for real-time threads.
  static std::shared_ptr<CycleLog> OfThisProcess();

  CycleLog();
  CycleLog(const CycleLog&) = delete;
  CycleLog& operator=(const CycleLog&) = delete;
  /// Logs what waits.
  ~CycleLog();

  void PutAside(LogTime time, LogLevel level, std::string_view source,
                std::string_view message) noexcept override;

  /// How many records have found no place.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_.value(); }

 private:
  struct Record;

  /// How many records of some sources have come, and have gone: the others wait.
  struct Share {
    SharedCounter<> come;
    Counter<> gone;
  };
  /// Sources of one share are told apart by nobody; there are more of them than tasks that flood.
  static constexpr std::size_t kShares = 64;

  void Run();
  void Drain();
  bool TellLost();
  Share& ShareOf(std::string_view source) noexcept;

  SharedSlotRing<> ring_;
  std::array<Share, kShares> shares_;
  SharedCounter<> lost_;
  std::uint64_t lost_told_ = 0;  // of the thread
  std::mutex mutex_;
  std::condition_variable stopped_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace tendon
