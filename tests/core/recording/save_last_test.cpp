#include <gtest/gtest.h>
#include <tendon/recording/save_last.h>

#include <cstdint>
#include <memory>

#include "recorder_fixture.h"

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

class SaveLastTest : public RecorderTest {};

TEST_F(SaveLastTest, WritesTheRowsThatATableHolds) {
  const auto robot = StartProcess("robot");
  ASSERT_TRUE(EventuallyTrue([&] { return NumberOf(*robot) > 300; }));
  ASSERT_TRUE(robot->Suspend("odometer"));
  const std::uint64_t newest = NumberOf(*robot);
  queue_ = std::make_shared<RecordingQueue>();
  client_ = std::make_unique<GcmClient>(
      Node(), GcmClient::Options{.name = "gcm save-last", .address = address_}, queue_);
  ASSERT_TRUE(client_->WaitUntilWatching());
  ASSERT_TRUE(EventuallyTrue(
      [&] { return client_->catalogue().FindComponent("robot", "odometer") != nullptr; }));
  GcmSystem system(*client_, 10s);

  const auto saved =
      SaveLast(system, queue_,
               {.patterns = {"robot"}, .files = {.file = file_}, .last = 1h, .timeout = 10s});

  ASSERT_TRUE(saved) << saved.error().message;
  ASSERT_EQ(saved->tables.size(), 1U);
  EXPECT_FALSE(saved->tables[0].failure);
  EXPECT_EQ(saved->tables[0].path, "robot/odometer/state");
  EXPECT_GT(saved->tables[0].past.reach, 250ms);
  const auto reader = Open();
  const auto rows = ByTopic(*reader)["robot/odometer/state/Number"];
  EXPECT_EQ(rows.size(), saved->tables[0].past.rows);
  ASSERT_GE(rows.size(), 300U);
  EXPECT_EQ(ValueOf<std::uint64_t>(rows.back()), newest);
  EXPECT_EQ(ValueOf<std::uint64_t>(rows.front()), newest + 1 - rows.size());
}

TEST_F(SaveLastTest, LeavesOutRowsThatAreOlder) {
  const auto robot = StartProcess("robot");
  ASSERT_TRUE(EventuallyTrue([&] { return NumberOf(*robot) > 300; }));
  ASSERT_TRUE(robot->Suspend("odometer"));
  queue_ = std::make_shared<RecordingQueue>();
  client_ = std::make_unique<GcmClient>(
      Node(), GcmClient::Options{.name = "gcm save-last", .address = address_}, queue_);
  ASSERT_TRUE(client_->WaitUntilWatching());
  ASSERT_TRUE(EventuallyTrue(
      [&] { return client_->catalogue().FindComponent("robot", "odometer") != nullptr; }));
  GcmSystem system(*client_, 10s);

  const auto saved =
      SaveLast(system, queue_,
               {.patterns = {"robot"}, .files = {.file = file_}, .last = 1ns, .timeout = 10s});

  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(saved->tables.at(0).past.rows, 0U);
  EXPECT_EQ(saved->tables.at(0).past.reach, 0ns);
}

}  // namespace
}  // namespace tendon::recording
