#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/machine/scarce_memory.h>
#include <support/wait.h>
#include <tendon/middleware/loopback.h>
#include <tendon/process/history/kept_rows.h>
#include <tendon/process/history/process_history.h>
#include <tendon/task/periodic_task.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tendon {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// Writes the number of its cycle into a short table, and raises it as an event.
class Counting final : public PeriodicTask {
 public:
  explicit Counting(std::string name, std::chrono::nanoseconds period = 1ms)
      : PeriodicTask(std::move(name), period) {
    state_table().Add(number_, "Number");
    state_table().SetLength(kRows);
    AddProvidedInterface("Control").AddEvent(passed_, "Passed");
  }
  ~Counting() override { Join(); }

  static constexpr std::size_t kRows = 512;

  void Run() override { passed_(number_++); }

 private:
  std::uint64_t number_ = 0;
  WriteEvent<std::uint64_t> passed_;
};

/// A manager whose components are kept by a history, as in a process.
class KeptManager final : public LocalManager {
 public:
  explicit KeptManager(HistoryOptions options = {}) : history_("robot", options) {
    SetObserver([this] { history_.Wake(); });
  }
  ~KeptManager() override {
    SetObserver(nullptr);
    EndAll(SteadyClock().Now() + 10s);
    for (const auto& component : components()) history_.Remove(component.name);
    Clear();
  }

  ProcessHistory& history() { return history_; }

 private:
  void OnAttached(Component& component) override { history_.Add(component); }
  void OnDetached(const Component& component) override { history_.Remove(component.name()); }

  ProcessHistory history_;
};

std::uint64_t RowsOf(const KeptManager& manager, const std::string& component) {
  return manager.Find(component)->tables().front()->next_tick();
}

TEST(ProcessHistory, KeepsRowsThatTheirTableHasOverwritten) {
  KeptManager manager;
  manager.Add<Counting>("arm");
  ASSERT_TRUE(manager.StartAll());
  const StateTable& table = *manager.Find("arm")->tables().front();
  const auto count = [&] {
    const auto kept = manager.history().Lock(table);
    KeptRows reader(table, kept.get());
    std::uint64_t rows = 0;
    const std::uint64_t end = table.next_tick();
    std::uint64_t tick = reader.FirstTick(SteadyClock().Now() - 1h);
    for (; (tick = reader.Read(tick, end)) < end; ++tick) ++rows;
    return rows;
  };
  constexpr std::uint64_t kMaxInTable = 2 * Counting::kRows;
  ASSERT_TRUE(EventuallyTrue([&] { return count() > kMaxInTable; }));
  ASSERT_TRUE(manager.StopAll());

  EXPECT_GT(table.oldest_tick(), 0U);
  // On a busy machine, some rows are missed. They are counted soon.
  EXPECT_TRUE(EventuallyTrue(
      [&] { return count() + manager.history().state().missed_rows >= table.next_tick(); }));
}

TEST(ProcessHistory, AnswersWithEventsPageByPage) {
  KeptManager manager;
  manager.Add<Counting>("arm");
  ASSERT_TRUE(manager.StartAll());
  message::ReadEvents wanted{.component = "arm", .interface = "Control", .last = 1h};
  ASSERT_TRUE(EventuallyTrue([&] {
    const auto page = manager.history().ReadEvents(wanted);
    return page && page->past.size() > 200;
  }));
  ASSERT_TRUE(manager.StopAll());

  const auto first = manager.history().ReadEvents(wanted);

  ASSERT_TRUE(first) << first.error().message;
  EXPECT_EQ(first->events, (std::vector<std::string>{"Passed"}));
  EXPECT_EQ(first->past.size() + first->lost, first->next);
  EXPECT_GT(first->past.size(), 200U);
  for (std::size_t i = 1; i < first->past.size(); ++i) {
    EXPECT_GE(first->past[i].time, first->past[i - 1].time);
  }
  wanted.epoch = first->epoch;
  for (wanted.first = first->next; wanted.first < first->end;) {
    const auto next = manager.history().ReadEvents(wanted);
    ASSERT_TRUE(next);
    ASSERT_GT(next->next, wanted.first);
    wanted.first = next->next;
  }
  EXPECT_EQ(wanted.first, first->end);
  wanted.first = UINT64_MAX;
  const auto after_all = manager.history().ReadEvents(wanted);
  ASSERT_TRUE(after_all);
  EXPECT_EQ(after_all->next, after_all->end);
  EXPECT_EQ(after_all->lost, 0U);
  wanted.epoch = first->epoch + 1;
  EXPECT_THAT(manager.history().ReadEvents(wanted).error().message, HasSubstr("was replaced"));
  wanted.interface = "Contrl";
  EXPECT_EQ(manager.history().ReadEvents(wanted).error().code, ErrorCode::kNotFound);
}

TEST(ProcessHistory, KeepsTheLog) {
  KeptManager manager;
  Log(LogLevel::kInfo, "arm", "it begins");
  manager.history().AddLog(LogLevel::kWarning, "hand", "forwarded");

  const auto page = manager.history().ReadLog({.last = 1h});

  ASSERT_TRUE(page);
  ASSERT_EQ(page->records.size(), 2U);
  EXPECT_EQ(page->records[0].text, "it begins");
  EXPECT_EQ(page->records[1].source, "hand");
  EXPECT_LE(page->since, page->records[0].time);
  EXPECT_EQ(page->next, page->end);
}

TEST(ProcessHistory, TheLogHasEachRecordThatWasAddedBefore) {
  KeptManager manager;
  for (std::uint64_t i = 1; i <= 5'000; ++i) {
    manager.history().Wake();  // its thread takes records at the same time
    manager.history().AddLog(LogLevel::kInfo, "arm" + std::to_string(i % 50), "record");

    const auto page = manager.history().ReadLog({});

    ASSERT_TRUE(page);
    ASSERT_EQ(page->end, i);
  }
}

TEST(ProcessHistory, ALogRecordWithoutMemoryIsCountedAsDropped) {
  KeptManager manager;
  const std::string text(960, 'x');
  {
    const ScarceMemory scarce(980);  // enough for the text, but not for the encoded record
    manager.history().AddLog(LogLevel::kInfo, "arm", text);
    EXPECT_EQ(manager.history().ReadLog({})->end, 1U);
  }

  const auto state = manager.history().state();

  EXPECT_LT(state.reach, state.age);
  EXPECT_TRUE(manager.history().ReadLog({.last = 1h})->records.empty());
}

TEST(ProcessHistory, NeverUsesMoreMemoryThanItsLimit) {
  constexpr std::size_t kLimit = std::size_t{256} << 10U;
  KeptManager manager({.memory = kLimit, .span = 30s});
  for (const char* name : {"a", "b", "c"}) manager.Add<Counting>(name);
  ASSERT_TRUE(manager.StartAll());

  ASSERT_TRUE(EventuallyTrue([&] {
    const auto state = manager.history().state();
    EXPECT_LE(state.memory, kLimit);
    return state.reach < state.age;
  })) << "it never became full";

  const auto state = manager.history().state();
  EXPECT_EQ(state.limit, kLimit);
  EXPECT_GT(state.memory, kLimit / 2);
}

TEST(ProcessHistory, ReachesBackToItsBeginWhileThereIsRoom) {
  KeptManager manager;
  manager.Add<Counting>("arm");

  const auto state = manager.history().state();

  EXPECT_EQ(state.reach, state.age);
  EXPECT_EQ(state.span, 30s);
}

TEST(ProcessHistory, ForgetsARemovedComponentAndGivesItsMemoryBack) {
  KeptManager manager;
  manager.Add<Counting>("arm");
  ASSERT_TRUE(manager.StartAll());
  ASSERT_TRUE(EventuallyTrue([&] { return manager.history().state().memory > 100'000; }));

  ASSERT_TRUE(manager.Remove("arm"));

  EXPECT_LT(manager.history().state().memory, 50'000U) << "only the log is left";
  EXPECT_EQ(manager.history().ReadEvents({.component = "arm", .interface = "Control"}).error().code,
            ErrorCode::kNotFound);
}

TEST(ProcessHistory, SaysIfTheMemoryDoesNotSufficeForEvents) {
  KeptManager manager({.memory = 50'000});
  manager.Add<Counting>("arm");

  const auto page = manager.history().ReadLog({.last = 1h});

  ASSERT_TRUE(page) << page.error().message;
  ASSERT_EQ(page->records.size(), 1U);
  EXPECT_THAT(page->records[0].text,
              HasSubstr("the events of robot/arm/Control are not kept in the history"));
  EXPECT_EQ(manager.history().ReadEvents({.component = "arm", .interface = "Control"}).error().code,
            ErrorCode::kNotFound);
}

TEST(ProcessHistory, TakesAnyBounds) {
  constexpr auto kLongest = std::chrono::nanoseconds::max();
  for (const HistoryOptions bounds : {HistoryOptions{.memory = 1, .span = 1ns},
                                      HistoryOptions{.memory = SIZE_MAX, .span = kLongest}}) {
    KeptManager manager(bounds);
    manager.Add<Counting>("arm");
    ASSERT_TRUE(manager.StartAll());
    ASSERT_TRUE(EventuallyTrue([&] { return RowsOf(manager, "arm") > 30; }));

    EXPECT_LE(manager.history().state().memory, bounds.memory);
    EXPECT_TRUE(manager.history().ReadLog({.last = kLongest}));
    const std::chrono::nanoseconds negative = std::chrono::nanoseconds::min();
    EXPECT_EQ(manager.history().ReadLog({.last = negative}).error().code, ErrorCode::kInvalid);
  }
}

TEST(ProcessHistory, KeepsNothingIfItsTimeIsZero) {
  KeptManager manager({.span = 0s});
  manager.Add<Counting>("arm");

  EXPECT_EQ(manager.history().state().limit, 0U);
  EXPECT_THAT(manager.history().ReadEvents({}).error().message, HasSubstr("keeps no history"));
}

TEST(ProcessHistory, KeepsNothingIfItIsOff) {
  KeptManager manager({.memory = 0});
  manager.Add<Counting>("arm");
  ASSERT_TRUE(manager.StartAll());
  ASSERT_TRUE(EventuallyTrue([&] { return RowsOf(manager, "arm") > 10; }));

  EXPECT_EQ(manager.history().state().memory, 0U);
  EXPECT_EQ(manager.history().state().limit, 0U);
  EXPECT_THAT(manager.history().ReadLog({}).error().message, HasSubstr("keeps no history"));
}

}  // namespace
}  // namespace tendon
