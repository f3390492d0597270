#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <tendon/interface/execution/block_when_full.h>
#include <tendon/interface/provided_interface.h>
#include <tendon/payload/codec.h>
#include <tendon/process/history/event_history.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <new>
#include <string>
#include <thread>
#include <vector>

namespace tendon {
namespace {

using namespace std::chrono_literals;

/// An interface with three events, which have one raising thread, as those of a task.
struct Control {
  Control() {
    provided.AddEvent(stopped, "Stopped");
    provided.AddEvent(passed, "Passed");
    provided.AddEvent(said, "Said");
  }

  Inbox inbox;
  ProvidedInterface provided{"Control", &inbox};
  VoidEvent stopped;
  WriteEvent<std::uint64_t> passed;
  WriteEvent<std::string> said;
};

class EventHistoryTest : public testing::Test {
 protected:
  std::vector<HistoryRecord> Records() {
    history.Gather();
    std::vector<HistoryRecord> records;
    HistoryRing::Cursor cursor = history.ring().From(0);
    while (const auto record = cursor.Next()) records.push_back(*record);
    return records;
  }
  template <typename T>
  static T ValueOf(const HistoryRecord& record) {
    T value{};
    EXPECT_TRUE(Decode(record.body, value));
    return value;
  }

  Control control;
  std::atomic<int> filling = 0;
  HistoryMemory memory{std::size_t{1} << 20U};
  EventHistory history{"arm", control.provided, memory, 30s, [this] { ++filling; }};
};

TEST_F(EventHistoryTest, KeepsEventsInOrderWithTheirTimesAndValues) {
  const SteadyTime before = SteadyClock().Now();
  control.passed(7);
  control.stopped();
  control.said("well");
  const SteadyTime after = SteadyClock().Now();

  const auto records = Records();

  ASSERT_EQ(records.size(), 3U);
  EXPECT_EQ(history.events(), (std::vector<std::string>{"Stopped", "Passed", "Said"}));
  EXPECT_EQ(records[0].tag, 1U);
  EXPECT_EQ(ValueOf<std::uint64_t>(records[0]), 7U);
  EXPECT_EQ(records[1].tag, 0U);
  EXPECT_EQ(records[2].tag, 2U);
  EXPECT_EQ(ValueOf<std::string>(records[2]), "well");
  std::int64_t last = before.time_since_epoch().count();
  for (std::uint64_t i = 0; i < 3; ++i) {
    EXPECT_EQ(records[i].number, i);
    EXPECT_GE(records[i].time, last);
    last = records[i].time;
  }
  EXPECT_LE(last, after.time_since_epoch().count());
}

TEST_F(EventHistoryTest, RaisingAllocatesNothing) {
  control.said(std::string(100, 'x'));
  Records();
  const std::string text(200, 'y');

  const AllocationGuard guard;
  for (std::uint64_t i = 0; i < 500; ++i) {  // also when the queue is full
    control.passed(i);
    control.said(text);
    control.stopped();
  }
}

TEST_F(EventHistoryTest, EventsThatComeTooFastAreCountedButNotAsLostByTheComponent) {
  for (std::uint64_t i = 0; i < 10'000; ++i) control.passed(i);

  const auto records = Records();

  EXPECT_GT(records.size(), 8U);
  EXPECT_EQ(records.size() + history.missed(), 10'000U);
  EXPECT_EQ(history.next_number(), 10'000U);
  EXPECT_EQ(control.passed.lost(), 0U);
}

TEST_F(EventHistoryTest, NeverLetsAComponentWait) {
  bool is_in_time = false;
  std::uint64_t raised = 0;
  for (int round = 0; round < 5 && !is_in_time; ++round) {  // the machine may stall in one of them
    const BlockWhenFull block;
    for (int i = 0; i < 1'000; ++i) control.passed(++raised);
    is_in_time = SteadyClock().Now() < BlockWhenFull::deadline();
  }

  EXPECT_TRUE(is_in_time);
  EXPECT_EQ(Records().size() + history.missed(), raised);
  EXPECT_GT(history.missed(), 0U);
}

TEST_F(EventHistoryTest, AsksToBeEmptiedWhenTheQueueIsHalfFull) {
  control.passed(1);
  EXPECT_EQ(filling, 0) << "an event usually makes no system call";

  for (std::uint64_t i = 0; i < 10'000; ++i) control.passed(i);

  EXPECT_GT(filling, 0);
}

TEST_F(EventHistoryTest, KeepsAValueOfVariableSize) {
  control.said(std::string(EventHistory::kLargestDynamicValue - 10, 'x'));

  const auto records = Records();

  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(ValueOf<std::string>(records[0]).size(), EventHistory::kLargestDynamicValue - 10);
}

TEST_F(EventHistoryTest, AValueThatIsTooLargeIsCounted) {
  control.said(std::string(EventHistory::kLargestValue, 'x'));
  control.said("short");

  const auto records = Records();

  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(ValueOf<std::string>(records[0]), "short");
  EXPECT_EQ(history.missed(), 1U);
}

TEST_F(EventHistoryTest, KeepsEventsOfAnotherThreadWhileItIsRead) {
  constexpr std::uint64_t kEvents = 20'000;
  std::thread raiser([this] {
    for (std::uint64_t i = 0; i < kEvents; ++i) control.passed(i);
  });

  while (history.next_number() < kEvents) history.Gather();
  raiser.join();

  EXPECT_EQ(Records().size() + history.missed(), kEvents);
}

TEST(EventHistory, KeepsNothingIfThereIsNoMemoryForItsQueue) {
  Control control;
  HistoryMemory memory(1024);
  EventHistory history("arm", control.provided, memory, 30s, [] {});

  control.stopped();
  history.Gather();

  EXPECT_FALSE(history.has_memory());
  EXPECT_TRUE(history.ring().empty());
  EXPECT_EQ(memory.used(), 0U);
}

/// A function whose second copy fails.
struct CopiedOnce {
  explicit CopiedOnce(int& counter) : copies(counter) {}
  CopiedOnce(CopiedOnce&&) = default;
  CopiedOnce(const CopiedOnce& other) : copies(other.copies) {
    if (++copies > 1) throw std::bad_alloc();
  }
  void operator()() const {}

  int& copies;
};

TEST(EventHistory, GivesItsMemoryBackAndHearsNothingIfItsConstructorFails) {
  Control control;
  HistoryMemory memory(std::size_t{1} << 20U);
  int copies = 0;
  EXPECT_THROW(
      EventHistory("arm", control.provided, memory, 30s, std::function<void()>(CopiedOnce(copies))),
      std::bad_alloc);
  ASSERT_EQ(copies, 2) << "one event has a handler";

  control.stopped();

  EXPECT_EQ(memory.used(), 0U);
}

TEST(EventHistory, KeepsEventsOfAComponentThatIsAddedWhenTheMemoryIsUsedUp) {
  HistoryMemory memory(std::size_t{1} << 20U);
  HistoryRing rows(memory, 1h);
  const std::vector<std::byte> row(800);
  for (std::uint64_t i = 0; i < 2'000; ++i) {
    rows.Append({.number = i, .time = static_cast<std::int64_t>(i), .body = row});
  }
  Control control;
  EventHistory history("arm", control.provided, memory, 1h, [] {});

  control.stopped();
  history.Gather();

  EXPECT_FALSE(history.ring().empty());
  EXPECT_LE(memory.used(), memory.limit());
}

TEST(EventHistory, GivesItsMemoryBackAndHearsNothingAfterItsEnd) {
  Control control;
  HistoryMemory memory(std::size_t{1} << 20U);
  {
    EventHistory history("arm", control.provided, memory, 30s, [] {});
    control.stopped();
    EXPECT_GT(memory.used(), 0U);
  }
  control.stopped();

  EXPECT_EQ(memory.used(), 0U);
}

}  // namespace
}  // namespace tendon
