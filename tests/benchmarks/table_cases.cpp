#include <benchmarks/measurement.h>
#include <benchmarks/seat.h>
#include <benchmarks/wiring.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

namespace tendon::benchmark {
namespace {

using Block = std::array<double, 128>;  // 1 kB

// The copied data is on the heap. The stack begins at another address in each process, and some
// addresses make every read slower.

double ReadNewestRow(std::uint64_t reads) {
  const auto table = std::make_unique<Table<Message>>();
  const Column<Message>& column = table->column();
  const auto owned = std::make_unique<Message>();
  Message& message = *owned;
  return NanosecondsEach(reads, [&](std::uint64_t) {
    (void)column.ReadNewest(message);
    Use(message);
  });
}

double CallReadFunction(std::uint64_t reads) {
  const auto wiring = std::make_unique<Wiring>();
  auto& get = wiring->get;
  const auto owned = std::make_unique<Message>();
  Message& message = *owned;
  return NanosecondsEach(reads, [&](std::uint64_t) {
    (void)get(message);
    Use(message);
  });
}

double LoadSeqlock(std::uint64_t reads) {
  const auto seqlock = std::make_unique<Seqlock<Message>>();
  const auto owned = std::make_unique<Message>();
  Message& message = *owned;
  return NanosecondsEach(reads, [&](std::uint64_t) {
    seqlock->Load(message);
    Use(message);
  });
}

template <typename Target>
double StoreInto(std::uint64_t stores) {
  const auto target = std::make_unique<Target>();
  const auto owned = std::make_unique<Message>();
  Message& message = *owned;
  return NanosecondsEach(stores, [&](std::uint64_t i) {
    message[0] = static_cast<double>(i);
    Use(message);
    target->Store(message);
  });
}

/// Returns the time of a read while a writer writes 1 kB without a pause. The reader reads once per
/// cycle of its own. A reader that reads again at once would take the mutex before the writer does,
/// and would find the old data in its cache.
template <typename Write, typename Read>
double ReadBesideWriter(std::uint64_t reads, Write write, Read read) {
  std::atomic<bool> is_ready = false;
  std::jthread writer([&is_ready, write](const std::stop_token& stop) {
    const Seat seat(Processor::kSecond);
    Block block{};
    for (double n = 0; !stop.stop_requested(); ++n) {
      block.fill(n);
      write(block);
      if (n == 0) is_ready = true;
    }
  });
  Insist([&] { return is_ready.load(); });
  constexpr std::chrono::microseconds kCycle(1);
  Block block{};
  std::chrono::duration<double, std::nano> took{0};
  for (std::uint64_t i = 0; i < reads; ++i) {
    const auto start = std::chrono::steady_clock::now();
    read(block);
    Use(block);
    const auto end = std::chrono::steady_clock::now();
    took += end - start;
    while (std::chrono::steady_clock::now() < end + kCycle) {
    }
  }
  return took.count() / static_cast<double>(reads);
}

double ReadTableBesideWriter(std::uint64_t reads) {
  const auto owner = std::make_unique<Table<Block>>();
  Table<Block>& table = *owner;
  const Column<Block>& column = table.column();
  return ReadBesideWriter(
      reads, [&table](const Block& block) { table.Store(block); },
      [&](Block& block) { (void)column.ReadNewest(block); });
}

double ReadMutexBesideWriter(std::uint64_t reads) {
  struct alignas(kSeparation) Guarded {  // away from other data on the reader's stack
    std::mutex mutex;
    Block block{};
  } shared;
  return ReadBesideWriter(
      reads,
      [&shared](const Block& block) {
        const std::scoped_lock lock(shared.mutex);
        shared.block = block;
      },
      [&](Block& block) {
        const std::scoped_lock lock(shared.mutex);
        block = shared.block;
      });
}

}  // namespace

std::vector<Case> TableCases(const Effort& effort) {
  constexpr double kReaderAndWriter = 2;
  // A thread that waits for a mutex sleeps, so only one processor is busy.
  constexpr double kOneAtATime = 1;
  const std::uint64_t alone = effort.Times(100'000);
  const std::uint64_t beside_writer = effort.Times(5'000);
  const auto with = [](std::uint64_t times, double (*function)(std::uint64_t)) {
    return [=] { return function(times); };
  };
  return {
      {.id = "S1",
       .what = "newest row, 64 B / seqlock",
       .gate = 3.0,
       .stretch = 2.7,
       .repetition = SideBySide({with(alone, ReadNewestRow)}, {with(alone, LoadSeqlock)})},
      {.id = "S2",
       .what = "the same through a bound read function / bare",
       .gate = 2,
       .stretch = 1.3,
       .repetition = SideBySide({with(alone, CallReadFunction)}, {with(alone, ReadNewestRow)})},
      {.id = "S3",
       .what = "reads beside a fast writer, 1 kB / mutex",
       .gate = 0.7,
       .stretch = 0.35,
       .repetition = SideBySide({with(beside_writer, ReadTableBesideWriter), kReaderAndWriter},
                                {with(beside_writer, ReadMutexBesideWriter), kOneAtATime})},
      {.id = "S4",
       .what = "advance of a row, 64 B / seqlock store",
       .gate = 2.5,
       .stretch = 1.5,
       .repetition = SideBySide({with(alone, StoreInto<Table<Message>>)},
                                {with(alone, StoreInto<Seqlock<Message>>)})},
  };
}

}  // namespace tendon::benchmark
