#include <tendon/task/cycle_log.h>

#include <tendon/base/clock.h>
#include <tendon/base/os/thread.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <new>
#include <string>

namespace tendon {
namespace {

/// A text in memory of fixed size.
template <std::size_t kSize>
struct FixedText {
  std::size_t size = 0;
  std::array<char, kSize> bytes;  // only the first `size` bytes are initialised

  void Set(std::string_view text) noexcept {
    constexpr std::string_view kMore = "...";
    size = std::min(text.size(), kSize);
    std::memcpy(bytes.data(), text.data(), size);
    if (text.size() <= kSize) return;
    std::memcpy(bytes.data() + kSize - kMore.size(), kMore.data(), kMore.size());
  }
  [[nodiscard]] std::string_view text() const { return {bytes.data(), size}; }
};

}  // namespace

struct CycleLog::Record {
  LogTime time;
  LogLevel level;
  SourceCount* source_count;
  FixedText<64> source;
  FixedText<kLongest> message;
};

std::shared_ptr<CycleLog> CycleLog::OfThisProcess() {
  static std::mutex mutex;
  static auto& of_this_process = *new std::weak_ptr<CycleLog>;  // never freed, like the log
  const std::scoped_lock lock(mutex);
  auto log = of_this_process.lock();
  if (!log) of_this_process = log = std::make_shared<CycleLog>();
  return log;
}

CycleLog::CycleLog() : ring_(kCapacity, sizeof(Record), alignof(Record)) {
  // Creates the logger now, so that this does not happen in a cycle.
  (void)IsLogged(LogLevel::kError);
  thread_ = std::thread([this] { Run(); });
}

CycleLog::~CycleLog() {
  {
    const std::scoped_lock lock(mutex_);
    stopping_ = true;
  }
  stopped_.notify_all();
  thread_.join();
}

void CycleLog::Defer(LogTime time, LogLevel level, std::string_view source,
                     std::string_view message) noexcept {
  SourceCount& source_count = CountOf(source);
  const auto waiting =
      static_cast<std::int64_t>(source_count.added.value() - source_count.logged.value());
  const auto free = static_cast<std::int64_t>(kCapacity - std::min(ring_.size(), kCapacity));
  std::byte* const slot = waiting < free ? ring_.Claim() : nullptr;
  if (slot == nullptr) return lost_.Add();
  source_count.added.Add();
  auto* const record = new (slot) Record;
  record->time = time;
  record->level = level;
  record->source_count = &source_count;
  record->source.Set(source);
  record->message.Set(message);
  ring_.Publish(slot);
}

void CycleLog::Run() {
  os::NameThisThread("log");
  SteadyTime next_report{};
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    stopped_.wait_for(lock, kDrainInterval);
    lock.unlock();
    Drain();
    if (const SteadyTime now = SteadyClock().Now(); now >= next_report) {
      if (ReportLost()) next_report = now + kBetweenReports;
    }
    lock.lock();
  }
  Drain();
  ReportLost();
}

void CycleLog::Drain() {
  // The number is limited, because tasks may add records faster than this loop takes them.
  for (std::size_t left = kCapacity; left > 0; --left) {
    const std::byte* const slot = ring_.Front();
    if (slot == nullptr) return;
    const Record& record = *std::launder(reinterpret_cast<const Record*>(slot));
    try {
      LogDeferred(record.time, record.level, record.source.text(), record.message.text());
    } catch (const std::exception&) {
      // If a sink fails, the other records must still be logged.
    }
    record.source_count->logged.Add();
    ring_.Release();
  }
}

bool CycleLog::ReportLost() {
  const std::uint64_t lost = lost_.value();
  if (lost == lost_reported_) return false;
  Log(LogLevel::kWarning, "log",
      std::to_string(lost - lost_reported_) +
          " log records of tasks are lost: the tasks log faster than the records can be written "
          "(buffer: " +
          std::to_string(kCapacity) + " records, divided between the tasks); log less often");
  lost_reported_ = lost;
  return true;
}

/// Chooses the count of a source by a hash of its name (FNV-1a).
CycleLog::SourceCount& CycleLog::CountOf(std::string_view source) noexcept {
  std::uint32_t hash = 2166136261U;
  for (const char c : source) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  }
  return source_counts_[hash % kSourceCounts];
}

}  // namespace tendon
