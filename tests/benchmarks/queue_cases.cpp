#include <benchmarks/measurement.h>
#include <benchmarks/seat.h>
#include <benchmarks/system_calls.h>
#include <benchmarks/wiring.h>
#include <support/allocation_guard.h>
#include <tendon/lockfree/slot_ring.h>

#include <atomic>
#include <cstring>
#include <memory>
#include <thread>

namespace tendon::benchmark {
namespace {

constexpr double kBoth = 2;  // processors

struct OurRing {
  SlotRing<StdAtomics, StrideOf(sizeof(Message), alignof(Message))> ring{kCapacity, sizeof(Message),
                                                                         alignof(Message)};

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

/// kReady: the message exists before it is sent. The producer is then ahead of the consumer, and
/// the ring is the bottleneck. kNew: the message is made just before it is sent, as in a cycle. The
/// consumer then waits for the producer.
enum class Messages { kReady, kNew };

/// Data that the producer writes for every message, in its own cache lines. Otherwise the consumer
/// would also fetch data that happens to be beside it on the stack.
template <typename T>
struct alignas(kSeparation) Apart {
  T value{};
};

/// Returns the time per message between two threads that never sleep. `produce(i)` runs in this
/// thread. The consumer has its own copy of `consume`, so that the two threads share no cache line.
template <typename Produce, typename Consume>
double BetweenTwoThreads(std::uint64_t messages, Produce produce, Consume consume) {
  std::atomic<bool> is_ready = false;
  std::jthread consumer([&is_ready, messages, consume] {
    const Seat seat(Processor::kSecond);
    is_ready = true;
    consume(messages);
  });
  Insist([&] { return is_ready.load(); });
  return NanosecondsEach(messages, produce);
}

template <typename Ring, Messages kMessages>
double Transfer(std::uint64_t messages) {
  const auto owner = std::make_unique<Ring>();
  Ring& ring = *owner;
  Apart<Message> sent;
  return BetweenTwoThreads(
      messages,
      [&](std::uint64_t i) {
        if constexpr (kMessages == Messages::kNew) sent.value[0] = static_cast<double>(i);
        Use(sent);
        Insist([&] { return ring.Push(sent.value); });
      },
      [&ring](std::uint64_t wanted) {
        Message received{};
        for (std::uint64_t i = 0; i < wanted; ++i) {
          Insist([&] { return ring.Pop(received); });
          Use(received);
        }
      });
}

double TransferCommands(std::uint64_t commands) {
  const auto owner = std::make_unique<Wiring>();
  Wiring& wiring = *owner;
  Apart<Argument> argument;
  return BetweenTwoThreads(
      commands,
      [&](std::uint64_t i) {
        argument.value[0] = static_cast<double>(i);
        Use(argument);
        Insist([&] { return static_cast<bool>(wiring.take(argument.value)); });
      },
      [&wiring](std::uint64_t wanted) {
        while (wiring.taken() < wanted) Insist([&] { return wiring.Execute() > 0; });
      });
}

double PostAndDispatch(std::uint64_t commands) {
  const auto wiring = std::make_unique<Wiring>();
  Argument argument{};
  return NanosecondsEach(commands, [&](std::uint64_t i) {
    argument[0] = static_cast<double>(i);
    (void)wiring->take(argument);
    wiring->Execute();
  });
}

double PushAndPop(std::uint64_t messages) {
  const auto ring = std::make_unique<BoostRing>();
  Message message{};
  return NanosecondsEach(messages, [&](std::uint64_t i) {
    message[0] = static_cast<double>(i);
    ring->Push(message);
    ring->Pop(message);
    Use(message);
  });
}

/// Counts the allocations and system calls of a caller while the server is awake.
std::optional<Pair> CountWhatACommandCosts(std::uint64_t commands) {
  Wiring wiring;
  std::jthread server([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) wiring.Execute();
  });
  const Argument argument{};
  std::uint64_t allocations = 0;
  const auto calls = CountSystemCalls([&](const std::function<void()>& from_now_on) {
    while (!wiring.take(argument)) {
    }
    const AllocationGuard guard;
    from_now_on();
    for (std::uint64_t i = 0; i < commands; ++i) {
      while (!wiring.take(argument)) {  // does not yield, because yielding is a system call
      }
    }
    allocations = guard.allocations();
  });
  if (!calls) return std::nullopt;
  return Pair{.ours = static_cast<double>(*calls + allocations) / static_cast<double>(commands)};
}

}  // namespace

std::vector<Case> QueueCases(const Effort& effort) {
  const std::uint64_t transferred = effort.Times(60'000);
  const std::uint64_t on_one_core = effort.Times(100'000);
  const auto with = [](std::uint64_t times, double (*function)(std::uint64_t)) {
    return [=] { return function(times); };
  };
  return {
      {.id = "Q1",
       .what = "ring, 64 B, throughput / boost::lockfree",
       .ratio = Ratio::kOfThroughputs,
       .gate = 1.15,
       .stretch = 1.45,
       .repetition = SideBySide({with(transferred, Transfer<OurRing, Messages::kReady>), kBoth},
                                {with(transferred, Transfer<BoostRing, Messages::kReady>), kBoth})},
      {.id = "D1",
       .what = "queued write command, 56 B / boost, 64 B",
       .ratio = Ratio::kOfThroughputs,
       .gate = 0.8,
       .stretch = 1.1,
       .repetition = SideBySide({with(transferred, TransferCommands), kBoth},
                                {with(transferred, Transfer<BoostRing, Messages::kNew>), kBoth})},
      {.id = "D3",
       .what = "post and dispatch on one core / boost push and pop",
       .gate = 5,
       .stretch = 3,
       .repetition =
           SideBySide({with(on_one_core, PostAndDispatch)}, {with(on_one_core, PushAndPop)})},
      {.id = "D4",
       .what = "allocations and system calls a queued command",
       .unit = "1",
       .gate = 0,
       .stretch = 0,
       .repetition = [times = effort.Times(1'000'000)] { return CountWhatACommandCosts(times); },
       .runs_once = true},
  };
}

}  // namespace tendon::benchmark
