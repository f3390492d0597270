#include <benchmarks/paired_benchmark.h>
#include <readerwriterqueue/readerwriterqueue.h>
#include <tendon/lockfree/slot_ring.h>
#include <tendon/state/state_table.h>

#include <array>
#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace tendon::benchmark {
namespace {

using Message = std::array<double, 8>;  // 64 bytes
using Block = std::array<double, 128>;  // 1 kB
constexpr std::size_t kCapacity = 1024;

template <typename Action>
double NanosecondsEach(std::uint64_t times, Action action) {
  const auto start = std::chrono::steady_clock::now();
  for (std::uint64_t i = 0; i < times; ++i) action(i);
  const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
  return took.count() / static_cast<double>(times);
}

/// The compiler must have `value` ready in memory, and believe that it is used.
template <typename T>
void Use(T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

struct OurRing {
  SlotRing<> ring{kCapacity, sizeof(Message), alignof(Message)};

  bool Push(const Message& message) {
    std::byte* const slot = ring.Claim();
    if (slot == nullptr) return false;
    std::memcpy(slot, &message, sizeof(message));
    ring.Publish();
    return true;
  }
  bool Pop(Message& message) {
    const std::byte* const slot = ring.Front();
    if (slot == nullptr) return false;
    std::memcpy(&message, slot, sizeof(message));
    ring.Release();
    return true;
  }
};

struct BoostRing {
  boost::lockfree::spsc_queue<Message, boost::lockfree::capacity<kCapacity>> ring;

  bool Push(const Message& message) { return ring.push(message); }
  bool Pop(Message& message) { return ring.pop(message); }
};

struct MoodycamelRing {
  moodycamel::ReaderWriterQueue<Message> ring{kCapacity};

  bool Push(const Message& message) { return ring.try_enqueue(message); }
  bool Pop(Message& message) { return ring.try_dequeue(message); }
};

template <typename Attempt>
void Insist(Attempt attempt) {
  constexpr int kPatience = 20'000;
  for (int failed = 1; !attempt(); ++failed) {
    if (failed % kPatience == 0) std::this_thread::yield();  // the other does not run
  }
}

/// Between two threads that never sleep.
template <typename Ring>
double Transfer() {
  constexpr std::uint64_t kMessages = 200'000;
  const auto ring = std::make_unique<Ring>();
  std::atomic<bool> is_ready = false;
  std::jthread consumer([&] {
    Message message{};
    is_ready = true;
    for (std::uint64_t i = 0; i < kMessages; ++i) {
      Insist([&] { return ring->Pop(message); });
      Use(message);
    }
  });
  Insist([&] { return is_ready.load(); });
  Message message{};
  return NanosecondsEach(kMessages, [&](std::uint64_t i) {
    message[0] = static_cast<double>(i);
    Insist([&] { return ring->Push(message); });
  });
}

/// One value behind a sequence number, copied as a whole: fast and, in the language, a race.
template <typename T>
class Seqlock {
 public:
  void Store(const T& value) {
    const auto sequence = sequence_.load(std::memory_order_relaxed);
    sequence_.store(sequence + 1, std::memory_order_relaxed);
    std::atomic_thread_fence(std::memory_order_release);
    std::memcpy(&value_, &value, sizeof(T));
    sequence_.store(sequence + 2, std::memory_order_release);
  }
  void Load(T& value) const {
    while (true) {
      const auto before = sequence_.load(std::memory_order_acquire);
      std::memcpy(&value, &value_, sizeof(T));
      std::atomic_thread_fence(std::memory_order_acquire);
      if (before % 2 == 0 && sequence_.load(std::memory_order_relaxed) == before) return;
    }
  }

 private:
  alignas(64) std::atomic<std::uint64_t> sequence_ = 0;
  T value_{};
};

/// A state table with one column.
template <typename T>
struct Table {
  T variable{};
  StateTable table;

  Table() {
    table.Add(variable, "Value");
    table.SetLength(StateTable::kMinimumLength);
    table.Prepare();
    table.Advance({});
  }
  void Store(const T& value) {
    variable = value;
    table.Advance({});
  }
  const Column<T>& column() const { return table.Find(variable); }
};

constexpr std::uint64_t kOperations = 400'000;

double ReadNewestRow() {
  const auto table = std::make_unique<Table<Message>>();
  const Column<Message>& column = table->column();
  Message message{};
  return NanosecondsEach(kOperations, [&](std::uint64_t) {
    (void)column.ReadNewest(message);
    Use(message);
  });
}

double LoadSeqlock() {
  const auto seqlock = std::make_unique<Seqlock<Message>>();
  Message message{};
  return NanosecondsEach(kOperations, [&](std::uint64_t) {
    seqlock->Load(message);
    Use(message);
  });
}

template <typename Target>
double StoreInto() {
  const auto target = std::make_unique<Target>();
  Message message{};
  return NanosecondsEach(kOperations, [&](std::uint64_t i) {
    message[0] = static_cast<double>(i);
    Use(message);
    target->Store(message);
  });
}

/// What a read takes while a writer writes 1 kB without a pause.
template <typename Write, typename Read>
double ReadBesideWriter(Write write, Read read) {
  constexpr std::uint64_t kReads = 50'000;
  std::atomic<bool> is_ready = false;
  std::jthread writer([&](const std::stop_token& stop) {
    Block block{};
    for (double n = 0; !stop.stop_requested(); ++n) {
      block.fill(n);
      write(block);
      is_ready.store(true, std::memory_order_relaxed);
    }
  });
  Insist([&] { return is_ready.load(); });
  Block block{};
  return NanosecondsEach(kReads, [&](std::uint64_t) {
    read(block);
    Use(block);
  });
}

double ReadTableBesideWriter() {
  const auto table = std::make_unique<Table<Block>>();
  const Column<Block>& column = table->column();
  return ReadBesideWriter([&](const Block& block) { table->Store(block); },
                          [&](Block& block) { (void)column.ReadNewest(block); });
}

double ReadMutexBesideWriter() {
  std::mutex mutex;
  Block shared{};
  return ReadBesideWriter(
      [&](const Block& block) {
        const std::scoped_lock lock(mutex);
        shared = block;
      },
      [&](Block& block) {
        const std::scoped_lock lock(mutex);
        block = shared;
      });
}

std::vector<Case> Cases() {
  constexpr double kBoth = 2;
  constexpr double kOneAtATime = 1;  // who waits for a mutex sleeps
  return {
      {"Q1",
       "ring, 64 B, throughput / boost::lockfree",
       Better::kHigherRatio,
       1.15,
       1.45,
       {Transfer<OurRing>, kBoth},
       {Transfer<BoostRing>, kBoth}},
      {"",
       "the same / moodycamel ReaderWriterQueue",
       Better::kHigherRatio,
       0,
       0,
       {Transfer<OurRing>, kBoth},
       {Transfer<MoodycamelRing>, kBoth}},
      {"S1",
       "newest row, 64 B / seqlock",
       Better::kLowerRatio,
       3.0,
       2.7,
       {ReadNewestRow},
       {LoadSeqlock}},
      {"S3",
       "reads beside a fast writer, 1 kB / mutex",
       Better::kLowerRatio,
       0.7,
       0.35,
       {ReadTableBesideWriter, kBoth},
       {ReadMutexBesideWriter, kOneAtATime}},
      {"S4",
       "advance of a row, 64 B / seqlock store",
       Better::kLowerRatio,
       2.5,
       1.5,
       {StoreInto<Table<Message>>},
       {StoreInto<Seqlock<Message>>}},
  };
}

}  // namespace
}  // namespace tendon::benchmark

int main() {
  constexpr int kRepetitions = 15;
  tendon::benchmark::Report(tendon::benchmark::Cases(), kRepetitions);
}
