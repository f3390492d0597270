#include <gtest/gtest.h>
#include <tendon/interface/connection.h>
#include <tendon/state/state_table.h>

#include <cstdint>
#include <memory>

namespace tendon {
namespace {

constexpr std::size_t kLength = 4;  // plus the row that is being replaced
constexpr std::size_t kDelay = 3;

/// A server with two tables, and a client. Commands return the newest and the delayed values of
/// each table.
struct Reading {
  StateTable fast{"fast"};
  StateTable slow{"slow"};
  std::int32_t fast_value = 0;
  std::int32_t slow_value = 0;
  ProvidedInterface provided{"Values", nullptr};
  RequiredInterface required{"Values", nullptr};
  ReadFunction<std::int32_t> get_fast;
  ReadFunction<std::int32_t> get_old_fast;
  ReadFunction<std::int32_t> get_lost_fast;
  ReadFunction<std::int32_t> get_slow;
  ReadFunction<std::int32_t> get_old_slow;
  std::unique_ptr<Connection> connection;

  Reading() {
    fast.Add(fast_value, "Value");
    slow.Add(slow_value, "Value");
    for (StateTable* table : {&fast, &slow}) table->SetLength(kLength);
    provided.AddCommandReadState(fast, fast_value, "GetFast");
    provided.AddCommandReadState(fast, fast_value, "GetOldFast", kDelay);
    provided.AddCommandReadState(fast, fast_value, "GetLostFast", 2 * kLength);
    provided.AddCommandReadState(slow, slow_value, "GetSlow");
    provided.AddCommandReadState(slow, slow_value, "GetOldSlow", kDelay);
    required.AddFunction(get_fast, "GetFast");
    required.AddFunction(get_old_fast, "GetOldFast");
    required.AddFunction(get_lost_fast, "GetLostFast");
    required.AddFunction(get_slow, "GetSlow");
    required.AddFunction(get_old_slow, "GetOldSlow");
    connection = *Connection::Make(required, provided, "client/Values", "server/Values");
  }

  void AdvanceFast(std::int32_t value) {
    fast_value = value;
    fast.Advance({});
  }
  void AdvanceSlow(std::int32_t value) {
    slow_value = value;
    slow.Advance({});
  }
};

constexpr std::int32_t kNoSample = -1;

/// Returns the value; kNoSample if there is none.
std::int32_t Read(ReadFunction<std::int32_t>& function) {
  std::int32_t value = kNoSample;
  const Status status = function(value);
  EXPECT_EQ(status, value == kNoSample ? Status::kNoSample : Status::kDone);
  return value;
}

TEST(ReadStateCommand, HasNoSampleBeforeEnoughRows) {
  Reading reading;

  EXPECT_EQ(Read(reading.get_fast), kNoSample);
  for (std::int32_t row = 0; row < static_cast<std::int32_t>(kDelay); ++row) {
    reading.AdvanceFast(row);
    EXPECT_EQ(Read(reading.get_old_fast), kNoSample);
  }
  reading.AdvanceFast(kDelay);
  EXPECT_EQ(Read(reading.get_old_fast), 0);
}

TEST(ReadStateCommand, FollowsTheNewestRowAtItsDelay) {
  Reading reading;
  for (std::int32_t row = 0; row < static_cast<std::int32_t>(kDelay); ++row) {
    reading.AdvanceFast(row);
  }

  for (std::int32_t row = kDelay; row < 30; ++row) {
    reading.AdvanceFast(row);
    ASSERT_EQ(Read(reading.get_fast), row);
    ASSERT_EQ(Read(reading.get_old_fast), row - static_cast<std::int32_t>(kDelay));
  }
}

TEST(ReadStateCommand, HasNoSampleIfTheTableIsTooShort) {
  Reading reading;

  for (std::int32_t row = 0; row < 30; ++row) reading.AdvanceFast(row);

  EXPECT_EQ(Read(reading.get_lost_fast), kNoSample);
}

TEST(ReadStateCommand, TablesOfOneComponentAdvanceIndependently) {
  Reading reading;
  for (std::int32_t row = 0; row < 12; ++row) {
    reading.AdvanceFast(row);
    if (row % 2 == 0) reading.AdvanceSlow(100 + row);
  }

  EXPECT_EQ(Read(reading.get_fast), 11);
  EXPECT_EQ(Read(reading.get_slow), 110);
  EXPECT_EQ(Read(reading.get_old_slow), 104);
}

}  // namespace
}  // namespace tendon
