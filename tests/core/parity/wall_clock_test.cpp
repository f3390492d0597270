#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <tendon/state/row_copy.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <ctime>

#include "core/parity/pair.h"

namespace {

/// The number of reads of the wall clock. While it jumps, each read returns another day.
std::atomic<int> the_days = 0;
std::atomic<bool> the_clock_jumps = false;

}  // namespace

/// Replaces the function of the C library, in this program and in its libraries.
extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept {
  const auto result = static_cast<int>(syscall(SYS_clock_gettime, clock, time));
  if (clock == CLOCK_REALTIME && the_clock_jumps) {
    constexpr time_t kDay = 24 * 3600;
    time->tv_sec += ++the_days % 2 == 0 ? kDay : -kDay;
  }
  return result;
}

namespace tendon_test {
namespace {

using tendon::Status;
using namespace std::chrono_literals;

struct JumpingWallClock : AnyPair {
  JumpingWallClock() { the_clock_jumps = true; }
  ~JumpingWallClock() override { the_clock_jumps = false; }
};

TEST_P(JumpingWallClock, AffectsNeitherRowsNorDeadlines) {
  const auto day = std::chrono::system_clock::now();
  ASSERT_GT(std::chrono::abs(std::chrono::system_clock::now() - day), 24h) << "it does not jump";
  const tendon::SteadyTime begin = tendon::SteadyClock().Now();

  pair.InClient([&](auto& port) {
    using P = PayloadIn<decltype(port)>;
    for (int i = 1; i <= 10; ++i) EXPECT_EQ(port.write.Wait(Sample<P>(i), kLong), Status::kDone);
    P value;
    EXPECT_EQ(port.settled.Wait(value, 1ms), Status::kTimeout);
  });
  pair.OnceInServer([&] { pair.server.Publish(); });

  const tendon::StateTable& table = *pair.server.table;
  ASSERT_TRUE(EventuallyTrue([&] { return table.next_tick() > 0; }));
  tendon::SteadyTime last{};
  tendon::RowCopy row(table);
  const std::uint64_t end = table.next_tick();
  for (std::uint64_t tick = table.oldest_tick(); tick < end; ++tick) {
    if (row.ReadAt(tick) != tendon::RowResult::kDone) continue;  // the row was replaced meanwhile
    EXPECT_GE(row.stamp().time, last);
    last = row.stamp().time;
  }
  EXPECT_GT(last, begin - kLong);
  EXPECT_LE(last, tendon::SteadyClock().Now());
}

TEST_P(JumpingWallClock, EndsNoWaitForAState) {
  const auto waited = pair.manager.WaitFor("server", tendon::ComponentState::kFaulted, 1ms);

  ASSERT_FALSE(waited.ok());
  EXPECT_EQ(waited.error().code, tendon::ErrorCode::kTimeout);
  ASSERT_TRUE(pair.manager.Suspend("server", kLong).ok());
  ASSERT_TRUE(pair.manager.Start("server", kLong).ok());
}

INSTANTIATE_TEST_SUITE_P(Parity, JumpingWallClock,
                         testing::Combine(testing::Values(Kind::kSignal),
                                          testing::ValuesIn(AllKinds())),
                         NameOfPair);

}  // namespace
}  // namespace tendon_test
