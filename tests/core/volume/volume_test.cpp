#include <core/volume/item.h>
#include <gtest/gtest.h>
#include <tendon/interface/connection.h>
#include <tendon/lockfree/slot_ring.h>
#include <tendon/state/state_table.h>

#include <atomic>
#include <cstring>
#include <memory>
#include <thread>

namespace tendon::volume {
namespace {

void ExpectAll(const Checker& checker) {
  EXPECT_EQ(checker.next(), items);
  EXPECT_EQ(checker.lost(), 0U);
  EXPECT_EQ(checker.torn(), 0U);
  EXPECT_EQ(checker.repeated_or_late(), 0U);
}

/// Yields the processor to the other thread until `is_done()`.
template <typename Predicate>
void YieldUntil(Predicate is_done) {
  while (!is_done()) std::this_thread::yield();
}

TEST(Checker, DetectsEveryKindOfFault) {
  Checker checker;
  checker.Take(ItemOf(0));
  checker.Take(ItemOf(3));
  checker.Take(ItemOf(3));
  Item mixed = ItemOf(4);
  mixed[6] = ItemOf(5)[6];
  checker.Take(mixed);

  EXPECT_EQ(checker.lost(), 2U);
  EXPECT_EQ(checker.repeated_or_late(), 1U);
  EXPECT_EQ(checker.torn(), 1U);
}

TEST(Volume, EveryItemPassesARing) {
  SlotRing<> ring(kCapacity, sizeof(Item), alignof(Item));
  Checker checker;

  std::jthread producer([&] {
    for (std::uint64_t number = 0; number < items; ++number) {
      const Item item = ItemOf(number);
      std::byte* slot = nullptr;
      YieldUntil([&] { return (slot = ring.Claim()) != nullptr; });
      std::memcpy(slot, &item, sizeof(item));
      ring.Publish();
    }
  });
  Item item{};
  for (std::uint64_t i = 0; i < items; ++i) {
    const std::byte* slot = nullptr;
    YieldUntil([&] { return (slot = ring.Front()) != nullptr; });
    std::memcpy(&item, slot, sizeof(item));
    ring.Release();
    checker.Take(item);
  }

  ExpectAll(checker);
}

/// The writer waits for the reader, so every row must arrive.
TEST(Volume, EveryRowOfATableIsRead) {
  StateTable table;
  Item variable{};
  table.Add(variable, "Item");
  table.SetLength(kCapacity);
  table.Prepare();
  const Column<Item>& column = table.Find(variable);
  std::atomic<std::uint64_t> read = 0;
  Checker checker;

  std::jthread writer([&] {
    for (std::uint64_t number = 0; number < items; ++number) {
      variable = ItemOf(number);
      YieldUntil([&] { return number < read.load(std::memory_order_acquire) + kCapacity; });
      table.Advance(SteadyTime(std::chrono::nanoseconds(number)));
    }
  });
  Item item{};
  std::uint64_t lost = 0;
  while (read < items) {
    const auto take = [&](const RowStamp& stamp, const Item& value) {
      if (stamp.tick != value[0]) ++lost;
      checker.Take(value);
    };
    const std::uint64_t next = column.ReadSince(read, item, lost, take);
    if (next == read) std::this_thread::yield();
    read.store(next, std::memory_order_release);
  }

  EXPECT_EQ(lost, 0U);
  ExpectAll(checker);
}

/// A component that raises events and a component that handles them. Each runs in a thread of the
/// test.
struct Pair {
  Inbox server_inbox;
  Inbox client_inbox;
  ProvidedInterface provided{"Control", &server_inbox};
  RequiredInterface required{"Robot", &client_inbox};
  WriteEvent<Item> event;
  Checker checker;
  std::atomic<std::uint64_t> handled = 0;
  std::unique_ptr<Connection> connection;

  Pair() {
    provided.AddEvent(event, "Happened");
    required.AddEventHandlerWrite(&Pair::Handle, this, "Happened");
    required.SetMailboxCapacity(kCapacity);
    server_inbox.SetAccepting(true);
    client_inbox.SetAccepting(true);
    connection = *Connection::Make(required, provided, "client/Robot", "server/Control");
  }

  void Handle(const Item& item) { checker.Take(item); }
};

TEST(Volume, EveryEventIsHandled) {
  const auto pair = std::make_unique<Pair>();

  std::jthread raiser([&] {
    for (std::uint64_t number = 0; number < items; ++number) {
      YieldUntil([&] { return number < pair->handled.load() + kCapacity; });
      pair->event(ItemOf(number));
    }
  });
  while (pair->handled < items) {
    const std::size_t executed = pair->client_inbox.ExecuteQueued();
    if (executed == 0) std::this_thread::yield();
    pair->handled += executed;
  }

  EXPECT_EQ(pair->event.lost(), 0U);
  ExpectAll(pair->checker);
}

}  // namespace
}  // namespace tendon::volume
