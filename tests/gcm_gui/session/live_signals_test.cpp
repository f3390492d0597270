#include <gcm_gui/session/column_feed.h>
#include <gcm_gui/session/live_signals.h>
#include <gcm_gui/views/raw_image.h>
#include <gtest/gtest.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/robot/image.h>

#include <QSignalSpy>
#include <algorithm>
#include <chrono>
#include <future>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "support/fakes.h"

namespace tendon::gui {
namespace {

/// Keeps the sinks, so that the test can act as the network.
class ScriptedTelemetry final : public TelemetryClient {
 public:
  struct Entry {
    TableSubscription table;
    std::shared_ptr<RowSink> sink;
  };

  Id Subscribe(const TableSubscription& table, std::shared_ptr<RowSink> sink) override {
    entries[++last_id_] = {table, std::move(sink)};
    return last_id_;
  }
  void Unsubscribe(Id id) override { entries.erase(id); }

  std::map<Id, Entry> entries;

 private:
  Id last_id_ = 0;
};

/// Sends rows of two doubles, `position[0..1]`. The first double is the tick.
void SendRows(RowSink& sink, std::uint64_t epoch, std::uint64_t first, std::size_t count,
              std::chrono::nanoseconds clock_offset = {}) {
  std::vector<std::uint64_t> ticks;
  std::vector<std::int64_t> times;
  std::vector<std::vector<std::byte>> cells;
  for (std::size_t i = 0; i < count; ++i) {
    ticks.push_back(first + i);
    times.push_back(static_cast<std::int64_t>((first + i) * 1'000'000));
    std::vector<std::byte> cell;
    Encode(std::array<double, 2>{static_cast<double>(first + i), 0.5}, cell);
    cells.push_back(std::move(cell));
  }
  RowBatch batch;
  batch.epoch = epoch;
  batch.count = count;
  batch.ticks = ticks;
  batch.times = times;
  batch.clock_offset = clock_offset;
  batch.cell = [&](std::size_t row, std::size_t) { return std::span<const std::byte>(cells[row]); };
  sink.OnRows(batch);
}

Schema PositionSchema() {
  return Schema::Structure("t.P",
                           {{"position", "rad", Schema::Array(Schema(Schema::Kind::kFloat64), 2)}});
}

class LiveSignalsTest : public ::testing::Test {
 protected:
  LiveSignalsTest() {
    QObject::connect(&live_, &SignalSource::samplesArrived, &live_,
                     [this](const QString& signal, std::span<const Sample> samples) {
                       for (const Sample& sample : samples) rows_[signal].push_back(sample);
                     });
  }

  RowSink& Sink() { return *telemetry_.entries.begin()->second.sink; }
  /// Returns the number of subscriptions to every row.
  [[nodiscard]] long Streams() const {
    return std::count_if(telemetry_.entries.begin(), telemetry_.entries.end(), [](const auto& one) {
      return one.second.table.rows.delivery != RowDelivery::kNewest;
    });
  }

  ScriptedTelemetry telemetry_;
  LiveSignals live_{telemetry_};
  std::map<QString, std::vector<Sample>> rows_;
  const QString first_ = "robot/arm/state.Joints.position[0]";
  const QString second_ = "robot/arm/state.Joints.position[1]";
};

TEST_F(LiveSignalsTest, SignalsOfOneColumnShareOneSubscription) {
  live_.subscribe(first_);
  live_.subscribe(second_);
  QObject owner;
  live_.watch(&owner, {"robot/arm/state.Joints"});

  ASSERT_EQ(Streams(), 1);
  const TableSubscription& table = telemetry_.entries.begin()->second.table;
  EXPECT_EQ(table.process, "robot");
  EXPECT_EQ(table.component, "arm");
  EXPECT_EQ(table.table, "state");
  EXPECT_EQ(table.columns, std::vector<std::string>{"Joints"});
}

TEST_F(LiveSignalsTest, ReportsARefusalToWatchers) {
  QSignalSpy refused(&live_, &SignalSource::valuesRefused);
  QObject owner;
  live_.watch(&owner, {"robot/arm/state.Joints"});
  Sink().OnStale({ErrorCode::kUnreachable, "its connection broke"});
  live_.drainValues();
  EXPECT_EQ(refused.count(), 0) << "its process is gone, which is shown of it";

  Sink().OnStale({ErrorCode::kNotFound, "it has no such column"});
  live_.drainValues();
  ASSERT_EQ(refused.count(), 1);
  EXPECT_EQ(refused[0][0], "robot/arm/state.Joints");
  EXPECT_EQ(refused[0][1], "it has no such column");

  Sink().OnSubscribed({PositionSchema()});
  live_.drainValues();
  EXPECT_EQ(refused.count(), 1);
}

TEST_F(LiveSignalsTest, DeliversEveryRowInOrderWithTickAndTime) {
  live_.subscribe(first_);
  Sink().OnSubscribed({PositionSchema()});
  SendRows(Sink(), 1, 100, 20);
  SendRows(Sink(), 1, 120, 20);

  live_.drain();

  const auto& rows = rows_[first_];
  ASSERT_EQ(rows.size(), 40u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].tick, 100 + i);
    EXPECT_EQ(rows[i].time_ns, static_cast<std::int64_t>((100 + i) * 1'000'000));
    EXPECT_EQ(rows[i].value, ExactNumber(static_cast<double>(100 + i)));
  }
}

TEST_F(LiveSignalsTest, IntegersKeepAllTheirDigitsAndStatesHaveTheirNames) {
  const QString stamp = "robot/arm/state.Counts.stamp";
  const QString mode = "robot/arm/state.Counts.mode";
  const QString ready = "robot/arm/state.Counts.is_ready";
  for (const QString& signal : {stamp, mode, ready}) live_.subscribe(signal);
  std::map<QString, ValueNamesPointer> names;
  QObject::connect(&live_, &SignalSource::namesLearned, &live_,
                   [&](const QString& signal, const ValueNamesPointer& learned) {
                     EXPECT_TRUE(rows_[signal].empty()) << "before its samples";
                     names[signal] = learned;
                   });
  const Schema mode_schema = Schema::Enum("t.Mode", {{"manual", 7}, {"off", 0}});
  Sink().OnSubscribed(
      {Schema::Structure("t.Counts", {{"stamp", "ns", Schema(Schema::Kind::kUint64)},
                                      {"mode", "", mode_schema},
                                      {"is_ready", "", Schema(Schema::Kind::kBool)}})});

  const std::vector<std::uint64_t> ticks{1};
  const std::vector<std::int64_t> times{1};
  std::vector<std::byte> cell;
  Encode(std::uint64_t{18'446'744'073'709'551'615U}, cell);
  std::vector<std::byte> rest;
  Encode(std::int32_t{7}, rest);
  cell.insert(cell.end(), rest.begin(), rest.end());
  cell.push_back(std::byte{1});
  RowBatch batch;
  batch.count = 1;
  batch.ticks = ticks;
  batch.times = times;
  batch.cell = [&](std::size_t, std::size_t) { return std::span<const std::byte>(cell); };
  Sink().OnRows(batch);
  live_.drain();

  ASSERT_EQ(rows_[stamp].size(), 1U);
  EXPECT_EQ(rows_[stamp][0].value, ExactNumber::Unsigned(18'446'744'073'709'551'615U));
  EXPECT_EQ(names.at(stamp), nullptr);
  ASSERT_NE(names.at(mode), nullptr);
  EXPECT_EQ(names.at(mode)->type, "t.Mode");
  EXPECT_EQ(names.at(mode)->textOf(rows_[mode].at(0).value), "manual");
  EXPECT_EQ(names.at(ready)->textOf(rows_[ready].at(0).value), "true");
}

TEST_F(LiveSignalsTest, ConvertsRowTimesOfAnotherHost) {
  live_.subscribe(first_);
  Sink().OnSubscribed({PositionSchema()});

  SendRows(Sink(), 1, 5000, 1, std::chrono::seconds(2));
  live_.drain();

  ASSERT_EQ(rows_[first_].size(), 1u);
  EXPECT_EQ(rows_[first_][0].time_ns, 3'000'000'000);
}

TEST_F(LiveSignalsTest, SignalsANewEpochBetweenItsRows) {
  live_.subscribe(first_);
  Sink().OnSubscribed({PositionSchema()});
  SendRows(Sink(), 1, 100, 2);
  live_.drain();
  QStringList heard;
  QObject::connect(&live_, &SignalSource::epochBegan, &live_, [&] { heard << "epoch"; });
  QObject::connect(&live_, &SignalSource::samplesArrived, &live_, [&] { heard << "rows"; });

  SendRows(Sink(), 1, 102, 2);
  SendRows(Sink(), 2, 0, 2);
  live_.drain();

  EXPECT_EQ(heard, (QStringList{"rows", "epoch", "rows"}));
}

TEST_F(LiveSignalsTest, SignalsStalenessOnce) {
  live_.subscribe(first_);
  Sink().OnSubscribed({PositionSchema()});
  QSignalSpy stale(&live_, &SignalSource::wentStale);

  Sink().OnStale({ErrorCode::kNotFound, "robot/arm has no table 'state'"});
  live_.drain();
  live_.drain();

  ASSERT_EQ(stale.count(), 1);
  EXPECT_EQ(stale.front().at(1).toString(), "robot/arm has no table 'state'");

  Sink().OnStale({ErrorCode::kUnreachable, "process 'robot' is lost (...); start it again first"});
  live_.drain();
  // No reason is needed, because the legend shows the missing source.
  EXPECT_EQ(stale.back().at(1).toString(), "");
}

TEST_F(LiveSignalsTest, NamesTheInvalidPartOfAPath) {
  live_.subscribe("robot/arm/state.Joints.torque[0]");
  QSignalSpy stale(&live_, &SignalSource::wentStale);

  Sink().OnSubscribed({PositionSchema()});
  live_.drain();

  ASSERT_EQ(stale.count(), 1);
  EXPECT_TRUE(stale.front().at(1).toString().contains("torque"));
}

TEST_F(LiveSignalsTest, AWatcherGetsTheNewestValuesOnly) {
  QObject owner;
  live_.watch(&owner, {"robot/arm/state.Joints"});
  Sink().OnSubscribed({PositionSchema()});
  SendRows(Sink(), 1, 100, 20);
  QSignalSpy values(&live_, &SignalSource::valuesArrived);

  live_.drainValues();
  live_.drainValues();

  ASSERT_EQ(values.count(), 1);
  const auto newest = values.front().at(1).value<ColumnValues>();
  ASSERT_EQ(newest.values.size(), 2u);
  EXPECT_EQ(newest.values[0], NumericValue(119.0));
  EXPECT_EQ(newest.fields->at(1).path, ".position[1]");
}

TEST_F(LiveSignalsTest, CountsLostRowsByPlace) {
  live_.subscribe(first_);
  Sink().OnSubscribed({PositionSchema()});
  EXPECT_EQ(live_.losses(first_), RowLosses{});

  RowBatch batch;  // a batch that reports only losses
  batch.lost.table = 7;
  batch.lost.network = 2;
  Sink().OnRows(batch);
  SendRows(Sink(), 1, 0, ColumnFeed::kMaxWaiting + 5);

  EXPECT_EQ(live_.losses(first_), (RowLosses{.table = 7, .network = 2, .viewer = 5}));
  EXPECT_EQ(live_.losses(second_), live_.losses(first_)) << "of the same column";
  EXPECT_EQ(live_.losses("robot/arm/state.Other"), RowLosses{});
}

TEST_F(LiveSignalsTest, DropsTheOldestOfTooManyWaitingRows) {
  live_.subscribe(first_);
  Sink().OnSubscribed({PositionSchema()});
  SendRows(Sink(), 1, 0, ColumnFeed::kMaxWaiting);
  SendRows(Sink(), 1, ColumnFeed::kMaxWaiting, 5);

  live_.drain();

  const auto& rows = rows_[first_];
  ASSERT_EQ(rows.size(), ColumnFeed::kMaxWaiting);
  EXPECT_EQ(rows.front().tick, 5U);
  EXPECT_EQ(rows.back().tick, ColumnFeed::kMaxWaiting + 4);
}

TEST_F(LiveSignalsTest, SubscribingDoesNotWaitForABatch) {
  live_.subscribe(first_);
  Sink().OnSubscribed({PositionSchema()});
  std::vector<std::byte> cell;
  Encode(std::array<double, 2>{}, cell);
  const std::vector<std::uint64_t> ticks{1};
  const std::vector<std::int64_t> times{1};
  std::promise<void> is_read;
  std::promise<void> is_plotted;
  auto plotted = is_plotted.get_future().share();
  std::once_flag once;
  bool has_waited = false;
  RowBatch batch;
  batch.count = 1;
  batch.ticks = ticks;
  batch.times = times;
  batch.cell = [&](std::size_t, std::size_t) {
    std::call_once(once, [&] {
      is_read.set_value();
      has_waited = plotted.wait_for(std::chrono::seconds(10)) != std::future_status::ready;
    });
    return std::span<const std::byte>(cell);
  };

  std::thread network([&] { Sink().OnRows(batch); });
  is_read.get_future().wait();
  live_.subscribe(second_);
  is_plotted.set_value();
  network.join();

  EXPECT_FALSE(has_waited);
  live_.drain();
  SendRows(Sink(), 1, 100, 3);
  live_.drain();
  EXPECT_EQ(rows_[second_].size(), 3U);
}

TEST_F(LiveSignalsTest, AWatcherGetsRowCountAndNewestTime) {
  QObject owner;
  live_.watch(&owner, {"robot/arm/state.Joints"});
  ColumnValues newest;
  QObject::connect(&live_, &SignalSource::valuesArrived, &owner,
                   [&](const QString&, const ColumnValues& values) { newest = values; });
  Sink().OnSubscribed({PositionSchema()});
  SendRows(Sink(), 1, 100, 20);

  live_.drainValues();

  EXPECT_EQ(newest.rows, 20U);
  EXPECT_EQ(newest.time, 119'000'000);
}

TEST_F(LiveSignalsTest, UnusedSubscriptionsEndAfterAWhile) {
  live_.subscribe(first_);
  {
    QObject owner;
    live_.watch(&owner, {"robot/arm/state.Joints", "robot/arm/state.Cycle"});
  }
  live_.release(first_);
  EXPECT_EQ(Streams(), 2);

  for (int sweep = 0; sweep < 3; ++sweep) live_.dropUnused();

  EXPECT_TRUE(telemetry_.entries.empty());
}

TEST_F(LiveSignalsTest, KeepsUsedSubscriptions) {
  live_.subscribe(first_);
  live_.subscribe(first_);
  live_.release(first_);

  for (int sweep = 0; sweep < 10; ++sweep) live_.dropUnused();

  EXPECT_EQ(telemetry_.entries.size(), 1u);
}

TEST_F(LiveSignalsTest, AnImageColumnIsAPictureNotNumbers) {
  QObject owner;
  live_.watch(&owner, {"robot/arm/state.Video"});
  robot::Image image;
  image.width = 40;
  image.height = 30;
  image.encoding = "mono8";
  image.step = 40;
  image.data.assign(1200, 7);
  ColumnValues heard;
  QObject::connect(&live_, &SignalSource::valuesArrived, &owner,
                   [&](const QString&, const ColumnValues& values) { heard = values; });

  Sink().OnSubscribed({SchemaOf<robot::Image>()});
  const std::vector<std::uint64_t> ticks{1};
  const std::vector<std::int64_t> times{1};
  std::vector<std::byte> cell;
  Encode(image, cell);
  RowBatch batch;
  batch.count = 1;
  batch.ticks = ticks;
  batch.times = times;
  batch.cell = [&](std::size_t, std::size_t) { return std::span<const std::byte>(cell); };
  Sink().OnRows(batch);
  live_.drainValues();

  ASSERT_NE(heard.picture, nullptr);
  EXPECT_EQ(heard.picture->width, 40U);
  EXPECT_EQ(heard.picture->data.size(), 1200);
  EXPECT_LT(heard.fields->size(), 20U);
}

TEST_F(LiveSignalsTest, IgnoresPathsThatNameNoColumn) {
  live_.subscribe("robot/arm");
  live_.subscribe("no path at all");

  EXPECT_TRUE(telemetry_.entries.empty());
}

TEST_F(LiveSignalsTest, RequestsTheLatestRowOnce) {
  QSignalSpy arrived(&live_, &SignalSource::valuesArrived);
  QObject owner;
  live_.watch(&owner, {"robot/arm/state.Joints"});
  ASSERT_EQ(telemetry_.entries.size(), 2u);
  RowSink& standing = *telemetry_.entries.rbegin()->second.sink;
  Sink().OnSubscribed({PositionSchema()});

  SendRows(standing, 1, 7, 1);
  live_.drainValues();
  live_.drainValues();

  ASSERT_EQ(arrived.count(), 1);
  EXPECT_EQ(arrived[0][1].value<ColumnValues>().values, (ExactValues({7, 0.5})));
  EXPECT_EQ(arrived[0][1].value<ColumnValues>().time, 7'000'000);
  EXPECT_EQ(telemetry_.entries.size(), 1u);
  EXPECT_TRUE(rows_.empty()) << "it is no row of the stream";
}

TEST_F(LiveSignalsTest, RequestsTheLatestRowAgainAfterAReconnect) {
  QObject owner;
  live_.watch(&owner, {"robot/arm/state.Joints"});
  const auto standing = [&] {
    return std::find_if(telemetry_.entries.begin(), telemetry_.entries.end(), [](const auto& one) {
      return one.second.table.rows.delivery == RowDelivery::kNewest;
    });
  };
  Sink().OnSubscribed({PositionSchema()});
  ASSERT_NE(standing(), telemetry_.entries.end());
  SendRows(*standing()->second.sink, 1, 100, 1);
  live_.drainValues();
  ASSERT_EQ(standing(), telemetry_.entries.end());

  Sink().OnStale({ErrorCode::kUnreachable, "its connection broke"});
  Sink().OnSubscribed({PositionSchema()});
  live_.drainValues();

  ASSERT_NE(standing(), telemetry_.entries.end());
  QSignalSpy values(&live_, &SignalSource::valuesArrived);
  SendRows(*standing()->second.sink, 1, 107, 1);
  live_.drainValues();
  ASSERT_EQ(values.count(), 1);
  EXPECT_EQ(values[0][1].value<ColumnValues>().values.at(0), NumericValue(107.0));
}

}  // namespace
}  // namespace tendon::gui
