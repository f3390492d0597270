#include <gtest/gtest.h>
#include <tendon/interface/observed_call.h>
#include <tendon/recording/recorder.h>

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "oracle.h"
#include "recorder_fixture.h"

namespace tendon::recording {
namespace {

using nlohmann::json;

class RecorderOracle : public RecorderTest {
 protected:
  void SetUp() override {
    if (!HasOracle()) GTEST_SKIP() << kNoOracle;
  }
};

TEST_F(RecorderOracle, DecodesEachRowEventAndCallOfARunningSystem) {
  const auto robot = StartProcess("robot");
  StartRecorder({.patterns = {"robot/odometer/state", "robot/odometer/Control"}}, {"robot"});
  const auto* const reverse =
      robot->Find("odometer")->FindProvided("Control")->FindCommand("Reverse");
  ASSERT_TRUE(EventuallyTrue([&] { return reverse->is_observed(); }));
  ASSERT_TRUE(EventuallyRows(300));
  Reverse();
  ASSERT_TRUE(EventuallyTrue([&] {
    const Counts counts = recorder_->status().counts;
    return counts.commands == 1 && counts.events >= 300;
  }));
  ASSERT_TRUE(EventuallyRows(recorder_->status().counts.rows + 100));
  ASSERT_TRUE(recorder_->Stop());
  const RecorderStatus status = recorder_->status();

  auto topics = recording::ByTopic(OfKind(RunOracle("decode.mjs", file_), "message"));

  const auto& numbers = topics["robot/odometer/state/Number"];
  const auto& halves = topics["robot/odometer/state/Half"];
  const auto number_in = [](const json& message) {
    return std::stoull(message["value"]["data"].get<std::string>());
  };
  ASSERT_EQ(numbers.size(), status.counts.rows);
  ASSERT_EQ(halves.size(), numbers.size());
  bool is_reversed = false;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto ticks =
        numbers[i]["sequence"].get<std::uint64_t>() - numbers[0]["sequence"].get<std::uint64_t>();
    ASSERT_EQ(number_in(numbers[i]), number_in(numbers[0]) + ticks);
    const auto half = halves[i]["value"]["data"].get<double>();
    is_reversed = is_reversed || half < 0;
    ASSERT_EQ(half, (is_reversed ? -0.5 : 0.5) * static_cast<double>(number_in(numbers[i])));
    ASSERT_EQ(halves[i]["log_time"], numbers[i]["log_time"]);
  }
  EXPECT_TRUE(is_reversed);
  const auto& events = topics["robot/odometer/Control/Passed"];
  EXPECT_EQ(events.size(), status.counts.events);
  for (std::size_t i = 1; i < events.size() && status.losses.all_events() == 0; ++i) {
    ASSERT_EQ(number_in(events[i]), number_in(events[i - 1]) + 1);
  }
  const auto& calls = topics["robot/odometer/Control/Reverse"];
  ASSERT_EQ(calls.size(), 1U);
  EXPECT_EQ(calls[0]["value"]["outcome"], static_cast<int>(CallOutcome::kExecuted));
}

}  // namespace
}  // namespace tendon::recording
