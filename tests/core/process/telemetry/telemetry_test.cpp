#include <gmock/gmock.h>

#include <mutex>
#include <set>

#include "core/process/telemetry/viewing.h"
#include "support/plant.h"

namespace {

using plant::Move;
using plant::Plant;
using tendon::Error;
using tendon::RowBatch;
using tendon::Schema;
using tendon::TableSubscription;
using testing::HasSubstr;

/// Records everything that it receives.
class Sink final : public tendon::RowSink {
 public:
  struct Row {
    std::uint64_t tick = 0;
    std::int64_t time = 0;
    std::vector<tendon::Bytes> cells;
  };

  void OnSubscribed(const std::vector<Schema>& columns) override {
    const std::scoped_lock lock(mutex_);
    columns_ = columns;
    ++subscribed_;
  }
  void OnRows(const RowBatch& batch) override {
    const std::scoped_lock held(gate);
    const std::scoped_lock lock(mutex_);
    epochs_.insert(batch.epoch);
    lost_table_ += batch.lost.table;
    lost_network_ += batch.lost.network;
    for (std::size_t row = 0; row < batch.count; ++row) {
      rows_.push_back({.tick = batch.ticks[row], .time = batch.times[row], .cells = {}});
      for (std::size_t column = 0; column < columns_.size(); ++column) {
        const auto cell = batch.cell(row, column);
        if (cell.size() < 1024) rows_.back().cells.emplace_back(cell.begin(), cell.end());
      }
    }
    clock_offset_ = batch.clock_offset;
    clock_uncertainty_ = batch.clock_uncertainty;
  }
  void OnStale(const Error& reason) override {
    const std::scoped_lock lock(mutex_);
    stale_ = reason.message;
  }

  std::vector<Row> rows() const { return Get(rows_); }
  std::size_t count() const {
    const std::scoped_lock lock(mutex_);
    return rows_.size();
  }
  std::vector<Schema> columns() const { return Get(columns_); }
  int subscribed() const { return Get(subscribed_); }
  std::string stale() const { return Get(stale_); }
  std::uint64_t lost_table() const { return Get(lost_table_); }
  std::uint64_t lost_network() const { return Get(lost_network_); }
  std::size_t epochs() const { return Get(epochs_).size(); }
  std::chrono::nanoseconds clock_offset() const { return Get(clock_offset_); }
  std::chrono::nanoseconds clock_uncertainty() const { return Get(clock_uncertainty_); }
  void Forget() {
    const std::scoped_lock lock(mutex_);
    rows_.clear();
  }

  std::mutex gate;  ///< while this is locked, the thread that delivers rows waits

 private:
  template <typename T>
  T Get(const T& value) const {
    const std::scoped_lock lock(mutex_);
    return value;
  }

  mutable std::mutex mutex_;
  std::vector<Row> rows_;
  std::vector<Schema> columns_;
  std::set<std::uint64_t> epochs_;
  int subscribed_ = 0;
  std::string stale_;
  std::uint64_t lost_table_ = 0;
  std::uint64_t lost_network_ = 0;
  std::chrono::nanoseconds clock_offset_{-1};
  std::chrono::nanoseconds clock_uncertainty_{-1};
};

void ExpectWithoutHoles(const std::vector<Sink::Row>& rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].tick, rows[i - 1].tick + 1) << "at row " << i;
    ASSERT_GT(rows[i].time, rows[i - 1].time);
  }
}

/// Writes a thousand rows of 64 KiB per second.
class Camera final : public tendon::PeriodicTask {
 public:
  explicit Camera(std::string name) : PeriodicTask(std::move(name), std::chrono::milliseconds(1)) {
    state_table().Add(image_, "Image");
  }
  ~Camera() override { Join(); }
  void Run() override { ++image_.front(); }

 private:
  std::array<double, 8192> image_{};
};

class Telemetry : public ViewingTest {
 protected:
  Telemetry() { StartRobot(); }

  void StartRobot() {
    robot = Start("robot");
    plant = &robot->Add<Plant>("plant");
    ASSERT_TRUE(robot->StartAll().ok());
  }

  std::unique_ptr<tendon::Process> robot;
  Plant* plant = nullptr;
  const TableSubscription kWanted{"robot", "plant", "state", {"Note", "Cycle", "Move"}};
};

TEST_P(Telemetry, DeliversEveryRowAtOneKilohertz) {
  const auto sink = std::make_shared<Sink>();
  const auto viewer = View();

  viewer->Subscribe(kWanted, sink);

  ASSERT_TRUE(EventuallyTrue([&] { return sink->count() >= 2000; }));
  ExpectWithoutHoles(sink->rows());
  EXPECT_EQ(sink->lost_table(), 0U);
  EXPECT_EQ(sink->lost_network(), 0U);
  EXPECT_EQ(sink->epochs(), 1U);
  EXPECT_EQ(sink->columns(),
            (std::vector{tendon::SchemaOf<plant::Note>(),
                         tendon::SchemaOf<tendon::CycleStatistics>(), tendon::SchemaOf<Move>()}));
}

TEST_P(Telemetry, DeliversAllColumnsOfARow) {
  auto& user = robot->Add<plant::Operator>("operator");
  ASSERT_TRUE(robot->StartAll().ok());
  ASSERT_TRUE(robot->Connect({"operator", "Robot"}, {"plant", "Control"}).ok());
  const auto sink = std::make_shared<Sink>();
  const auto viewer = View();
  viewer->Subscribe(kWanted, sink);
  ASSERT_TRUE(EventuallyTrue([&] { return sink->count() > 0; }));

  for (std::uint64_t i = 1; i <= 50; ++i) {
    const std::string text(i, 'x');
    ASSERT_TRUE(EventuallyTrue([&] { return bool(user.write({.text = text})); }));
    ASSERT_TRUE(EventuallyTrue([&] { return bool(user.move_to({.number = i})); }));
  }
  const auto reached = [&] {
    const auto rows = sink->rows();
    Move move;
    return tendon::Decode(rows.back().cells.at(2), move) && move.number == 50;
  };
  ASSERT_TRUE(EventuallyTrue(reached));

  const auto rows = sink->rows();
  ExpectWithoutHoles(rows);
  for (const auto& row : rows) {
    plant::Note note;
    tendon::CycleStatistics cycle;
    Move move;
    ASSERT_TRUE(tendon::Decode(row.cells.at(0), note));
    ASSERT_TRUE(tendon::Decode(row.cells.at(1), cycle));
    ASSERT_TRUE(tendon::Decode(row.cells.at(2), move));
    ASSERT_GE(note.text.size(), move.number);  // written earlier, or in the same cycle
    ASSERT_LE(note.text.size(), move.number + 1);
  }
}

TEST_P(Telemetry, DeliversTheSameRowsToSeveralViewers) {
  const auto first_sink = std::make_shared<Sink>();
  const auto second_sink = std::make_shared<Sink>();
  const auto first = View();
  const auto second = View();

  first->Subscribe(kWanted, first_sink);
  second->Subscribe(kWanted, second_sink);
  const auto other_sink = std::make_shared<Sink>();
  second->Subscribe({"robot", "plant", "state", {"Move"}}, other_sink);

  for (const auto& sink : {first_sink, second_sink, other_sink}) {
    ASSERT_TRUE(EventuallyTrue([&] { return sink->count() >= 500; }));
    ExpectWithoutHoles(sink->rows());
    EXPECT_EQ(sink->lost_table() + sink->lost_network(), 0U);
  }
}

TEST_P(Telemetry, WithAPeriodDeliversOneRowOfEach) {
  using std::chrono::milliseconds;
  const auto sink = std::make_shared<Sink>();
  const auto viewer = View();
  TableSubscription wanted = kWanted;
  wanted.rows.period = milliseconds(20);

  viewer->Subscribe(wanted, sink);

  ASSERT_TRUE(EventuallyTrue([&] { return sink->count() >= 20; }));
  const auto rows = sink->rows();
  const auto period = std::chrono::nanoseconds(wanted.rows.period).count();
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_GT(rows[i].time / period, rows[i - 1].time / period) << "at row " << i;
  }
  EXPECT_EQ(sink->lost_table() + sink->lost_network(), 0U);
}

TEST_P(Telemetry, QueuesNoNewestRowsForABusyViewer) {
  const auto sink = std::make_shared<Sink>();
  const auto other = std::make_shared<Sink>();
  const auto viewer = View();
  const auto watcher = View();
  TableSubscription wanted = kWanted;
  wanted.rows.delivery = tendon::RowDelivery::kNewest;
  viewer->Subscribe(wanted, sink);
  watcher->Subscribe(kWanted, other);
  ASSERT_TRUE(EventuallyTrue([&] { return sink->count() >= 2; }));

  std::unique_lock held(sink->gate);
  const std::size_t before = other->count();
  ASSERT_TRUE(EventuallyTrue([&] { return other->count() > before + 500; }));
  const std::uint64_t written = other->rows().back().tick;
  sink->Forget();
  held.unlock();

  ASSERT_TRUE(EventuallyTrue([&] { return sink->count() >= 3; }));
  const auto rows = sink->rows();
  EXPECT_GE(rows.at(1).tick, written);  // the first row was written before
  EXPECT_EQ(sink->lost_table() + sink->lost_network(), 0U);
}

TEST_P(Telemetry, RefusesAPeriodBelowZero) {
  const auto sink = std::make_shared<Sink>();
  const auto viewer = View();
  TableSubscription wanted = kWanted;
  wanted.rows.period = std::chrono::milliseconds(-1);

  viewer->Subscribe(wanted, sink);

  EXPECT_TRUE(EventuallyTrue([&] { return !sink->stale().empty(); }));
  EXPECT_THAT(sink->stale(), HasSubstr("below zero"));
}

TEST_P(Telemetry, HasNoClockOffsetOnOneHost) {
  const auto sink = std::make_shared<Sink>();
  const auto viewer = View();

  viewer->Subscribe(kWanted, sink);

  EXPECT_TRUE(EventuallyTrue([&] {
    return sink->clock_uncertainty() >= std::chrono::nanoseconds(0) &&
           sink->clock_uncertainty() < std::chrono::hours(1);
  }));
  EXPECT_EQ(sink->clock_offset(), std::chrono::nanoseconds(0));
}

TEST_P(Telemetry, AStoppedViewerLosesOnlyItsOwnRows) {
  robot->Add<Camera>("camera");
  ASSERT_TRUE(robot->StartAll().ok());
  const TableSubscription wanted{"robot", "camera", "state", {"Image"}};
  const auto blocked_sink = std::make_shared<Sink>();
  const auto sink = std::make_shared<Sink>();
  const auto blocked = View();
  const auto viewer = View();
  blocked->Subscribe(wanted, blocked_sink);
  viewer->Subscribe({"robot", "plant", "state", {"Move"}}, sink);
  ASSERT_TRUE(EventuallyTrue([&] { return blocked_sink->count() > 0 && sink->count() > 0; }));

  // Blocks for a shorter time than the limit after which a silent process counts as lost.
  const auto hold_up = [&] {
    std::unique_lock held(blocked_sink->gate);
    const std::size_t before = sink->count();
    EventuallyTrue([&] { return sink->count() > before + 500; }, std::chrono::seconds(1));
    const bool others_go_on = sink->count() > before + 100;  // a busy machine sends fewer rows
    held.unlock();
    const std::size_t blocked_before = blocked_sink->count();
    EXPECT_TRUE(EventuallyTrue([&] { return blocked_sink->count() > blocked_before + 10; }));
    return others_go_on && blocked_sink->lost_network() > 0;
  };
  EXPECT_TRUE(EventuallyTrue(hold_up));
  const std::size_t blocked_rows = blocked_sink->count();
  EXPECT_TRUE(EventuallyTrue([&] { return blocked_sink->count() > blocked_rows + 500; }));
  ExpectWithoutHoles(sink->rows());
  EXPECT_EQ(sink->lost_table(), 0U);
  EXPECT_EQ(sink->lost_network(), 0U);
  EXPECT_EQ(sink->subscribed(), 1) << sink->stale();
}

TEST_P(Telemetry, EndsWithItsSubscription) {
  const auto sink = std::make_shared<Sink>();
  const auto viewer = View();
  const auto id = viewer->Subscribe(kWanted, sink);
  const auto other = std::make_shared<Sink>();
  viewer->Subscribe(kWanted, other);
  ASSERT_TRUE(EventuallyTrue([&] { return sink->count() > 0 && other->count() > 0; }));

  viewer->Unsubscribe(id);
  const std::size_t count = sink->count();

  const std::size_t others = other->count();
  EXPECT_TRUE(EventuallyTrue([&] { return other->count() > others + 100; }));
  EXPECT_EQ(sink->count(), count);
}

TEST_P(Telemetry, WaitsForAMissingTableAndReportsIt) {
  const auto sink = std::make_shared<Sink>();
  const auto viewer = View();
  viewer->Subscribe({"robot", "camera", "state", {"Image"}}, sink);
  EXPECT_TRUE(EventuallyTrue([&] { return !sink->stale().empty(); }));
  EXPECT_THAT(sink->stale(), HasSubstr("no component robot/camera"));
  const auto typo = std::make_shared<Sink>();
  viewer->Subscribe({"robot", "plant", "state", {"Mov"}}, typo);
  EXPECT_TRUE(EventuallyTrue([&] { return !typo->stale().empty(); }));
  EXPECT_THAT(typo->stale(), HasSubstr("has no column 'Mov'; did you mean 'Move'?"));

  robot->Add<Camera>("camera");
  ASSERT_TRUE(robot->StartAll().ok());

  EXPECT_TRUE(EventuallyTrue([&] { return sink->count() > 0; }));
}

TEST_P(Telemetry, ResumesWhenTheProcessReturns) {
  const auto sink = std::make_shared<Sink>();
  const auto viewer = View();
  viewer->Subscribe(kWanted, sink);
  ASSERT_TRUE(EventuallyTrue([&] { return sink->count() > 0; }));

  robot.reset();
  EXPECT_TRUE(EventuallyTrue([&] { return !sink->stale().empty(); }));
  sink->Forget();
  StartRobot();
  viewer->Retry("robot");

  EXPECT_TRUE(EventuallyTrue([&] { return sink->count() > 100; }));
  EXPECT_EQ(sink->subscribed(), 2);
  EXPECT_EQ(sink->epochs(), 2U);
  ExpectWithoutHoles(sink->rows());
}

TEST_P(Telemetry, ResumesWhenARemovedComponentReturns) {
  const auto sink = std::make_shared<Sink>();
  const auto viewer = View();
  viewer->Subscribe(kWanted, sink);
  ASSERT_TRUE(EventuallyTrue([&] { return sink->count() > 0; }));

  ASSERT_TRUE(robot->Remove("plant").ok());
  EXPECT_TRUE(EventuallyTrue([&] { return !sink->stale().empty(); }));
  sink->Forget();
  plant = &robot->Add<Plant>("plant");
  ASSERT_TRUE(robot->StartAll().ok());

  EXPECT_TRUE(EventuallyTrue([&] { return sink->count() > 100; }));
  EXPECT_EQ(sink->epochs(), 2U);
}

INSTANTIATE_TEST_SUITE_P(Over, Telemetry, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
