#include <tendon/state/row_copy.h>

#include <algorithm>

#include "core/parity/pair.h"

namespace tendon_test {
namespace {

using tendon::RowResult;
using tendon::RowStamp;
using tendon::Status;
using tendon::SteadyTime;
using namespace std::chrono_literals;

constexpr std::size_t kKept = 7;  // number of rows of the table `history`

/// State tables of every kind of component, read by the test's thread.
struct Tables : AnyServer {
  tendon::StateTable& history = *pair.server.history;

  static SteadyTime TimeOf(int row) { return SteadyTime(1s * row); }

  /// Writes the rows `first` to `last` in the server's thread. Each row has the samples of its
  /// number.
  void Write(int first, int last) {
    pair.OnceInServer([&] {
      for (int row = first; row <= last; ++row) {
        pair.server.number = row;
        ForEachPort(pair.server.ports, [row](auto& port) { Fill(port.goal, row); });
        history.Advance(TimeOf(row));
      }
    });
  }
  /// Calls `body(column, value)` for the column of each payload.
  template <typename Body>
  void ForEachColumn(Body body) {
    ForEachPort(pair.server.ports, [&](auto& port) {
      PayloadIn<decltype(port)> value;
      body(history.Find(port.goal), value);
    });
  }
};

TEST_P(Tables, HaveNoSampleBeforeTheFirstRow) {
  ForEachColumn([](const auto& column, auto& value) {
    Fill(value, 9);
    EXPECT_EQ(column.ReadNewest(value), Status::kNoSample);
    EXPECT_EQ(column.ReadAt(0, value), RowResult::kNotYet);
    EXPECT_EQ(column.ReadDelayed(0, value), RowResult::kNotYet);
    EXPECT_TRUE(IsSample(value, 9));
  });
}

TEST_P(Tables, AreReadByNewestIndexAndDelayThroughEveryWrap) {
  for (int last = 1; last <= 30; ++last) {
    Write(last, last);

    ForEachColumn([&](const auto& column, auto& value) {
      RowStamp stamp;
      ASSERT_EQ(column.ReadNewest(value, stamp), Status::kDone);
      EXPECT_TRUE(IsSample(value, last));
      EXPECT_EQ(stamp, (RowStamp{static_cast<std::uint64_t>(last - 1), TimeOf(last)}));
      for (int delay = 0; delay < std::min<int>(last, kKept); ++delay) {
        ASSERT_EQ(column.ReadDelayed(static_cast<std::size_t>(delay), value), RowResult::kDone);
        EXPECT_TRUE(IsSample(value, last - delay)) << delay << " rows before " << last;
        ASSERT_EQ(column.ReadAt(static_cast<std::uint64_t>(last - 1 - delay), value),
                  RowResult::kDone);
        EXPECT_TRUE(IsSample(value, last - delay));
      }
    });
  }
}

TEST_P(Tables, DistinguishLostFromFutureRows) {
  Write(1, 30);

  ForEachColumn([](const auto& column, auto& value) {
    Fill(value, 9);
    EXPECT_EQ(column.ReadAt(30, value), RowResult::kNotYet);
    EXPECT_EQ(column.ReadAt(30 - kKept - 2, value), RowResult::kOvertaken);
    EXPECT_EQ(column.ReadDelayed(kKept + 2, value), RowResult::kOvertaken);
    EXPECT_TRUE(IsSample(value, 9));
  });
}

TEST_P(Tables, AreReadByTime) {
  Write(1, 30);

  ForEachColumn([](const auto& column, auto& value) {
    EXPECT_EQ(column.ReadAtTime(TimeOf(28), value), RowResult::kDone);
    EXPECT_TRUE(IsSample(value, 28));
    EXPECT_EQ(column.ReadAtTime(TimeOf(29) - 1ns, value), RowResult::kDone);
    EXPECT_TRUE(IsSample(value, 28));
    EXPECT_EQ(column.ReadAtTime(TimeOf(1000), value), RowResult::kDone);
    EXPECT_TRUE(IsSample(value, 30));
    EXPECT_EQ(column.ReadAtTime(TimeOf(2), value), RowResult::kOvertaken);
  });
}

TEST_P(Tables, AreReadByRangeAndLossesAreCounted) {
  Write(1, 30);

  ForEachColumn([](const auto& column, auto& value) {
    int next = 30 - static_cast<int>(kKept) + 1;
    std::uint64_t lost = 0;
    const auto next_tick =
        column.ReadSince(0, value, lost, [&](const RowStamp& stamp, const auto& row) {
          EXPECT_TRUE(IsSample(row, next));
          EXPECT_EQ(stamp.time, TimeOf(next));
          ++next;
        });
    EXPECT_EQ(next_tick, 30U);
    EXPECT_EQ(next, 31);
    EXPECT_EQ(lost, 30U - kKept);
    int rows = 0;
    lost = 0;
    const auto count = [&](const RowStamp&, const auto&) { ++rows; };
    EXPECT_EQ(column.ReadRange(25, 28, value, lost, count), 28U);
    EXPECT_EQ(rows, 3);
    EXPECT_EQ(lost, 0U);
  });
}

TEST_P(Tables, AreReadByCompleteRowsOfOneCycle) {
  tendon::RowCopy copy(history);
  Write(1, 12);

  ASSERT_EQ(copy.ReadNewest(), Status::kDone);
  ASSERT_EQ(copy.ReadAt(9), RowResult::kDone);

  EXPECT_EQ(copy.stamp().time, TimeOf(10));
  ForEachColumn([&](const auto& column, auto& value) {
    EXPECT_EQ(copy.Get(column, value), RowResult::kDone);
    EXPECT_TRUE(IsSample(value, 10));
  });
}

TEST_P(Tables, FilterTheirColumnsOncePerRow) {
  for (int row = 1; row <= 10; ++row) {
    Write(row, row);

    int doubled = 0;
    EXPECT_EQ(history.Find(pair.server.doubled).ReadNewest(doubled), Status::kDone);
    EXPECT_EQ(doubled, 2 * row);
  }
}

INSTANTIATE_TEST_SUITE_P(Parity, Tables, testing::ValuesIn(AllKinds()), NameOfKind);

/// The tables that tasks write by themselves.
struct TaskTables : AnyServer {
  const tendon::StateTable& table = *pair.server.table;
};

TEST_P(TaskTables, GetOneRowPerCycleUnlessAdvancedByHand) {
  const std::uint64_t before = table.next_tick();
  EXPECT_TRUE(EventuallyTrue([&] {
    pair.OnceInServer([] {});
    return table.next_tick() >= before + 3;
  }));
  ASSERT_TRUE(pair.manager.Stop("server").ok());

  if (GetParam() != Kind::kContinuous) {
    EXPECT_EQ(table.next_tick(), pair.server.runs);
  } else {
    EXPECT_LE(table.next_tick(), pair.server.runs);  // at most one row per millisecond
  }
  EXPECT_EQ(pair.server.history->next_tick(), 0U);
}

TEST_P(TaskTables, UseMonotonicTimeStamps) {
  const SteadyTime begin = tendon::SteadyClock().Now();
  const std::uint64_t first = table.next_tick();
  EXPECT_TRUE(EventuallyTrue([&] {
    pair.OnceInServer([] {});
    return table.next_tick() >= first + 20;
  }));
  ASSERT_TRUE(pair.manager.Stop("server").ok());

  tendon::RowCopy row(table);
  SteadyTime last{};
  for (std::uint64_t tick = table.oldest_tick(); tick < table.next_tick(); ++tick) {
    ASSERT_EQ(row.ReadAt(tick), RowResult::kDone);
    EXPECT_GE(row.stamp().time, last);
    last = row.stamp().time;
  }
  EXPECT_GT(last, begin);
  EXPECT_LE(last, tendon::SteadyClock().Now());
}

TEST_P(TaskTables, AreInterfacesWithOneReadPerColumn) {
  const auto* const state = pair.server.component().FindProvided("state");
  const auto* const further = pair.server.component().FindProvided("state-history");

  ASSERT_NE(state, nullptr);
  ASSERT_NE(further, nullptr);
  for (const char* const column : {"Cycle", "CycleSummary", "Joints", "Scan"}) {
    EXPECT_NE(state->FindCommand(column), nullptr) << column;
  }
  EXPECT_NE(further->FindCommand("Doubled"), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Parity, TaskTables, testing::ValuesIn(TaskKinds()), NameOfKind);

}  // namespace
}  // namespace tendon_test
