#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/folder.h>
#include <support/wait.h>
#include <tendon/base/log.h>
#include <tendon/middleware/loopback.h>
#include <tendon/process/process.h>
#include <tendon/recording/local_system.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/recorder.h>
#include <tendon/recording/save_last.h>
#include <tendon/task/periodic_task.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "recordings.h"

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using testing::Contains;
using testing::HasSubstr;

/// Writes the number of its cycle to a column, and raises it as an event.
class Pedometer final : public PeriodicTask {
 public:
  explicit Pedometer(std::string name) : PeriodicTask(std::move(name), 1ms) {
    state_table().Add(steps_, "Steps");
    state_table().SetLength(8192);  // long enough for a busy machine
    AddProvidedInterface("Control").AddEvent(stepped_, "Stepped");
  }
  ~Pedometer() override { Join(); }

  void Run() override { stepped_(++steps_); }

 private:
  std::uint64_t steps_ = 0;
  WriteEvent<std::uint64_t> stepped_;
};

/// A process without a GCM, and a recorder in this process.
class LocalSystemTest : public testing::Test {
 protected:
  LocalSystemTest() {
    process_->Add<Pedometer>("pedometer");
    EXPECT_TRUE(process_->StartAll());
  }
  ~LocalSystemTest() override {
    recorder_.reset();
    system_.reset();
  }

  void StartRecorder(const std::vector<std::string>& patterns) {
    system_ = std::make_shared<LocalSystem>(process_->OpenLocalAccess(), queue_);
    auto recorder =
        Recorder::Start(system_, queue_, {.patterns = patterns, .files = {.file = file_}});
    ASSERT_TRUE(recorder) << recorder.error().message;
    recorder_ = *std::move(recorder);
  }
  std::map<std::string, std::vector<mcap::StoredMessage>> Read() {
    std::map<std::string, std::vector<mcap::StoredMessage>> all;
    auto reader = mcap::Reader::Open(file_);
    EXPECT_TRUE(reader) << reader.error().message;
    if (!reader) return all;
    for (auto& message : mcap::ReadAll(**reader, {.order = mcap::Query::Order::kFile})) {
      all[message.topic].push_back(std::move(message));
    }
    return all;
  }

  const test::Folder folder_;
  const std::filesystem::path file_ = folder_.path() / "run.mcap";
  std::unique_ptr<Process> process_ = std::make_unique<Process>(
      "robot", ProcessOptions{.middleware = std::make_shared<LoopbackMiddleware>(
                                  std::make_shared<LoopbackNetwork>())});
  const std::shared_ptr<RecordingQueue> queue_ = std::make_shared<RecordingQueue>();
  std::shared_ptr<LocalSystem> system_;
  std::unique_ptr<Recorder> recorder_;
};

TEST_F(LocalSystemTest, ARecorderRecordsItsOwnProcessWithoutAGcm) {
  StartRecorder({"robot/**"});
  ASSERT_TRUE(EventuallyTrue([&] {
    const Counts counts = recorder_->status().counts;
    return counts.rows >= 200 && counts.events >= 200;
  }));
  Log(LogLevel::kWarning, "pedometer", "a stone in the shoe");
  ASSERT_TRUE(EventuallyTrue([&] { return recorder_->status().counts.log > 0; }));
  ASSERT_TRUE(recorder_->Stop());

  auto topics = Read();
  const auto& rows = topics["robot/pedometer/state/Steps"];
  ASSERT_GE(rows.size(), 200U);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(ValueOf<std::uint64_t>(rows[i]), ValueOf<std::uint64_t>(rows[i - 1]) + 1);
  }
  EXPECT_GE(topics["robot/pedometer/Control/Stepped"].size(), 200U);
  std::vector<std::string> log;
  for (const auto& message : topics[kLogTopic]) log.push_back(ValueOf<RosLog>(message).msg);
  EXPECT_THAT(log, Contains("a stone in the shoe"));
  Catalogue catalogue;
  for (const auto& message : topics[kCatalogueTopic]) {
    const auto change = ValueOf<CatalogueChange>(message);
    if (message.sequence == 0) catalogue = Catalogue::At(change.revision - 1);
    EXPECT_TRUE(catalogue.Apply(change));
  }
  EXPECT_NE(catalogue.FindComponent("robot", "pedometer"), nullptr);
}

TEST_F(LocalSystemTest, AComponentThatIsAddedLaterIsRecorded) {
  StartRecorder({"robot/later"});
  process_->Add<Pedometer>("later");
  ASSERT_TRUE(process_->Start("later"));

  ASSERT_TRUE(EventuallyTrue([&] { return recorder_->status().counts.rows >= 50; }));
  ASSERT_TRUE(recorder_->Stop());

  EXPECT_TRUE(Read().contains("robot/later/state/Steps"));
}

TEST_F(LocalSystemTest, AComponentCanBeRemovedWhileItIsRecorded) {
  StartRecorder({"robot/**"});
  ASSERT_TRUE(EventuallyTrue([&] { return recorder_->status().counts.rows >= 50; }));

  ASSERT_TRUE(process_->Remove("pedometer"));

  ASSERT_TRUE(EventuallyTrue([&] { return recorder_->status().tables == 0; }));
  EXPECT_TRUE(recorder_->Stop());
}

TEST_F(LocalSystemTest, SaveLastSaysThatTheProcessIsBusy) {
  const auto busy =
      std::make_shared<LocalAccess>("robot", 1U, [](ProcessContent& /*content*/) { return false; });
  LocalSystem system(busy, queue_);

  const auto saved =
      SaveLast(system, queue_, {.patterns = {"**"}, .files = {.file = file_}, .last = 1s});

  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().message, HasSubstr("process 'robot' is busy"));
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(LocalSystemTest, ReachesOnlyItsOwnProcess) {
  StartRecorder({"robot/**"});

  const auto schema = system_->FindSchema("desk", Fingerprint{1, 2});

  ASSERT_FALSE(schema);
  EXPECT_THAT(schema.error().message, HasSubstr("reaches only this process, not 'desk'"));
}

TEST_F(LocalSystemTest, AnEndedProcessIsNotDescribedAnyMore) {
  const auto access = process_->OpenLocalAccess();
  ProcessContent content;
  ASSERT_TRUE(EventuallyTrue([&] { return access->TryDescribe(content); }));
  EXPECT_EQ(content.components.size(), 1U);

  process_.reset();

  EXPECT_FALSE(access->TryDescribe(content));
}

}  // namespace
}  // namespace tendon::recording
