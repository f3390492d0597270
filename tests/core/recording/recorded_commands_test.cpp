#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/folder.h>
#include <support/wait.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/interface/observed_call.h>
#include <tendon/middleware/loopback.h>
#include <tendon/payload/json.h>
#include <tendon/process/process.h>
#include <tendon/recording/csv_export.h>
#include <tendon/recording/local_system.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/recorder.h>
#include <tendon/recording/recording_format.h>
#include <tendon/task/periodic_task.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "recordings.h"

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using testing::HasSubstr;

/// Counts how often it was told to move.
class Lift final : public PeriodicTask {
 public:
  explicit Lift(std::string name) : PeriodicTask(std::move(name), 1ms) {
    state_table().Add(height_, "Height");
    auto& control = AddProvidedInterface("Control");
    control.AddCommandWrite(&Lift::Move, this, "Move");
    control.AddCommandVoid(&Lift::Stop, this, "Stop");
    control.AddCommandWrite(&Lift::Note, this, "Note");
    control.AddCommandWriteReturn(&Lift::Plan, this, "Plan");
    control.AddCommandReadState(state_table(), height_, "GetHeight");
    control.AddEvent(moved_, "Moved");
  }
  ~Lift() override { Join(); }

  void Run() override { ProcessQueuedCommands(); }
  [[nodiscard]] std::uint64_t moves() const { return moves_.load(); }

 private:
  void Move(double height) {
    height_ = height;
    moved_(height);
    ++moves_;
  }
  void Stop() {}
  void Note(const std::string& /*text*/) {}
  void Plan(double height, std::string& plan) { plan = "to " + std::to_string(height); }

  double height_ = 0.0;
  std::atomic<std::uint64_t> moves_{0};
  WriteEvent<double> moved_;
};

class Pilot final : public Component {
 public:
  explicit Pilot(std::string name) : Component(std::move(name)) {
    auto& lift = AddRequiredInterface("Lift");
    lift.SetMailboxCapacity(4096);
    lift.AddFunction(move, "Move");
    lift.AddFunction(stop, "Stop");
    lift.AddFunction(note, "Note");
    lift.AddFunction(plan, "Plan");
  }

  WriteFunction<double> move;
  VoidFunction stop;
  WriteFunction<std::string> note;
  WriteReturnFunction<double, std::string> plan;
};

/// `robot` has a lift and a pilot, `desk` another pilot of the same lift.
class RecordedCommands : public testing::Test {
 protected:
  RecordedCommands() {
    auto gcm = GlobalManager::Start(
        Node(), {.address = "127.0.0.1:0", .state_folder = folder_.path() / "gcm"});
    EXPECT_TRUE(gcm) << gcm.error().message;
    gcm_ = *std::move(gcm);
  }
  ~RecordedCommands() override { recorder_.reset(); }

  std::shared_ptr<Middleware> Node() { return std::make_shared<LoopbackMiddleware>(network_); }
  std::unique_ptr<Process> MakeProcess(const std::string& name) {
    return std::make_unique<Process>(name,
                                     ProcessOptions{.middleware = Node(), .gcm = gcm_->address()});
  }
  void StartRobot() {
    robot_ = MakeProcess("robot");
    lift_ = &robot_->Add<Lift>("lift");
    local_ = &robot_->Add<Pilot>("pilot");
    EXPECT_TRUE(robot_->Connect({"pilot", "Lift"}, {"lift", "Control"}));
    EXPECT_TRUE(robot_->StartAll());
  }
  void StartDesk() {
    desk_ = MakeProcess("desk");
    remote_ = &desk_->Add<Pilot>("pilot");
    const auto connected = desk_->Connect({"desk", "pilot", "Lift"}, {"robot", "lift", "Control"});
    EXPECT_TRUE(connected) << connected.error().message;
    EXPECT_TRUE(desk_->StartAll());
    EXPECT_TRUE(EventuallyTrue([&] { return remote_->move.is_connected(); }));
  }
  [[nodiscard]] std::filesystem::path Path(const std::string& name) const {
    return folder_.path() / name;
  }

  void StartRecorder(const std::string& file, RecorderOptions options,
                     std::size_t most_waiting = RecordingQueue::kMaxBytes) {
    queue_ = std::make_shared<RecordingQueue>(most_waiting);
    client_ = std::make_unique<GcmClient>(
        Node(), GcmClient::Options{.name = "gcm record", .address = gcm_->address()}, queue_);
    ASSERT_TRUE(client_->WaitUntilWatching());
    ASSERT_TRUE(EventuallyTrue([&] {
      const Catalogue catalogue = client_->catalogue();
      return catalogue.FindComponent("robot", "lift") != nullptr;
    }));
    options.files.file = Path(file);
    auto recorder = Recorder::Start(*client_, queue_, std::move(options));
    ASSERT_TRUE(recorder) << recorder.error().message;
    recorder_ = *std::move(recorder);
  }
  [[nodiscard]] std::uint64_t recorded() const { return recorder_->status().counts.commands; }
  /// Waits until the recorder sees all further calls of these commands. The reply that tells it so
  /// comes before the first call.
  void AwaitRecorder(const std::vector<std::string>& commands) {
    const ProvidedInterface* control = lift_->FindProvided("Control");
    for (const std::string& command : commands) {
      ASSERT_TRUE(EventuallyTrue([&] { return control->FindCommand(command)->is_observed(); }));
    }
  }

  /// The calls of a command in a file, as JSON without the time that they took.
  std::vector<std::string> CallsIn(const std::string& file, const std::string& topic) {
    std::vector<std::string> calls;
    const auto reader = mcap::Reader::Open(Path(file));
    EXPECT_TRUE(reader) << reader.error().message;
    if (!reader) return calls;
    for (const auto& message : mcap::ReadAll(**reader, {.order = mcap::Query::Order::kFile})) {
      if (message.topic != topic) continue;
      for (const auto& [id, channel] : (*reader)->channels()) {
        if (channel.topic != topic) continue;
        EXPECT_EQ(channel.metadata.at(kKindKey), kCommandKind);
        const auto type = Schema::Parse(channel.metadata.at(kSchemaKey));
        EXPECT_TRUE(type);
        std::string data = message.data.substr(kEncapsulationSize);
        std::fill_n(data.begin(), 8, '\0');
        const auto json = ToJson(*type, mcap::BytesOf(data));
        calls.push_back(json ? *json : json.error().message);
        break;
      }
    }
    return calls;
  }
  static std::string Executed(const std::string& argument, const std::string& client) {
    return R"({"took":0,"outcome":"executed","status":"done",)" +
           (argument.empty() ? "" : R"("argument":)" + argument + ",") + R"("client":")" + client +
           "\"}";
  }

  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  const test::Folder folder_;
  std::unique_ptr<GlobalManager> gcm_;
  std::unique_ptr<Process> robot_;
  std::unique_ptr<Process> desk_;
  Lift* lift_ = nullptr;
  Pilot* local_ = nullptr;
  Pilot* remote_ = nullptr;
  std::shared_ptr<RecordingQueue> queue_;
  std::unique_ptr<GcmClient> client_;
  std::unique_ptr<Recorder> recorder_;
};

TEST_F(RecordedCommands, ComeFromLocalAndRemoteClients) {
  StartRobot();
  StartDesk();
  StartRecorder("run.mcap", {.patterns = {"robot"}});
  AwaitRecorder({"Move", "Plan", "Stop"});

  EXPECT_TRUE(local_->stop());
  EXPECT_TRUE(local_->move(1.5));
  ASSERT_TRUE(EventuallyTrue([&] { return lift_->moves() == 1; }));
  EXPECT_TRUE(remote_->move(2.5));
  std::string plan;
  EXPECT_EQ(remote_->plan.Wait(3.0, plan, 20s), Status(Status::kDone));

  ASSERT_TRUE(EventuallyTrue([&] { return recorded() == 4; }));
  ASSERT_TRUE(recorder_->Stop());
  EXPECT_EQ(recorder_->status().losses.all_events(), 0U);
  EXPECT_EQ(CallsIn("run.mcap", "robot/lift/Control/Move"),
            (std::vector{Executed("1.5", "pilot/Lift"), Executed("2.5", "desk/pilot/Lift")}));
  EXPECT_EQ(CallsIn("run.mcap", "robot/lift/Control/Plan"),
            std::vector<std::string>{R"({"took":0,"outcome":"executed","status":"done",)"
                                     R"("argument":3,"result":"to 3.000000",)"
                                     R"("client":"desk/pilot/Lift"})"});
  EXPECT_EQ(CallsIn("run.mcap", "robot/lift/Control/Stop"),
            std::vector{Executed("", "pilot/Lift")});
  EXPECT_TRUE(CallsIn("run.mcap", "robot/lift/Control/GetHeight").empty());
}

TEST_F(RecordedCommands, AreChosenByTheirPaths) {
  StartRobot();
  StartRecorder("run.mcap", {.patterns = {"robot/lift/Control.Stop"}});
  AwaitRecorder({"Stop"});
  EXPECT_TRUE(local_->move(1.0));
  EXPECT_TRUE(local_->stop());
  ASSERT_TRUE(EventuallyTrue([&] { return recorded() == 1; }));
  ASSERT_TRUE(recorder_->Stop());

  EXPECT_FALSE(CallsIn("run.mcap", "robot/lift/Control/Stop").empty());
  EXPECT_TRUE(CallsIn("run.mcap", "robot/lift/Control/Move").empty());
}

/// The recorder of the test has little room, and the calls come faster than they can be sent.
TEST_F(RecordedCommands, AreRecordedOnceOrCountedAsLost) {
  constexpr std::uint64_t kCalls = 30'000;
  constexpr std::size_t kFewBytes = 20'000;
  StartRobot();
  StartRecorder("run.mcap", {.patterns = {"robot/lift/Control.Move"}}, kFewBytes);
  AwaitRecorder({"Move"});

  std::uint64_t refused = 0;
  for (std::uint64_t i = 0; i < kCalls; ++i) {
    for (; !local_->move(static_cast<double>(i)); ++refused) std::this_thread::yield();
  }
  ASSERT_TRUE(EventuallyTrue([&] { return lift_->moves() == kCalls; }));
  const auto lost = [&] {
    const auto losses = recorder_->status().losses.events;
    const auto of_move = losses.find("robot/lift/Control.Move");
    return of_move == losses.end() ? 0 : of_move->second;
  };
  ASSERT_TRUE(EventuallyTrue([&] { return recorded() + lost() >= kCalls + refused; }))
      << recorded() << " and " << lost() << " of " << kCalls + refused;
  ASSERT_TRUE(recorder_->Stop());
  EXPECT_EQ(recorded() + lost(), kCalls + refused);

  const auto reader = mcap::Reader::Open(Path("run.mcap"));
  ASSERT_TRUE(reader);
  double last = -1.0;
  std::uint64_t executed = 0;
  for (const auto& message : mcap::ReadAll(**reader, {.order = mcap::Query::Order::kFile})) {
    if (message.topic != "robot/lift/Control/Move") continue;
    const auto body = mcap::BytesOf(message.data).subspan(kEncapsulationSize);
    if (HeaderOfCall(body).outcome == CallOutcome::kRefused) continue;  // it is repeated
    double height = 0.0;
    ASSERT_TRUE(Decode(body.subspan(kEncodedSize<CallHeader>, sizeof height), height));
    ASSERT_GT(height, last) << "each call once, in order";
    last = height;
    ++executed;
  }
  EXPECT_LE(executed, kCalls);
  EXPECT_GT(executed, 0U);
}

TEST_F(RecordedCommands, WithLargeArgumentsAreRecordedWhole) {
  StartRobot();
  StartRecorder("run.mcap", {.patterns = {"robot/lift/Control.Note"}});
  AwaitRecorder({"Note"});

  for (const std::size_t size : {10, 300, 100'000, 500}) {
    EXPECT_TRUE(local_->note(std::string(size, 'n')));
  }
  ASSERT_TRUE(EventuallyTrue([&] { return recorded() == 4; }));
  ASSERT_TRUE(recorder_->Stop());

  const auto call = [](std::size_t size) {
    return Executed('"' + std::string(size, 'n') + '"', "pilot/Lift");
  };
  EXPECT_EQ(CallsIn("run.mcap", "robot/lift/Control/Note"),
            (std::vector{call(10), call(300), call(100'000), call(500)}));
}

TEST_F(RecordedCommands, StartARecording) {
  StartRobot();
  const auto condition = ParseCondition("robot/lift/Control.Move");
  ASSERT_TRUE(condition);
  StartRecorder("run.mcap", {.patterns = {"robot/lift/Control.*"}, .start_when = *condition});

  (void)local_->stop();
  EXPECT_TRUE(recorder_->status().is_waiting);
  ASSERT_TRUE(EventuallyTrue([&] {
    (void)local_->move(1.0);
    return !recorder_->status().is_waiting;
  }));
  ASSERT_TRUE(EventuallyTrue([&] {
    (void)local_->move(2.0);
    return recorded() > 0;
  }));
  EXPECT_TRUE(recorder_->Stop());
}

TEST_F(RecordedCommands, EndARecordingAndAreInIt) {
  StartRobot();
  const auto condition = ParseCondition("robot/lift/Control.Move");
  ASSERT_TRUE(condition);
  StartRecorder("run.mcap", {.patterns = {"robot/lift/Control.*"}, .stop_when = *condition});
  AwaitRecorder({"Move", "Plan"});  // the second one only by the recorder, not by its condition

  EXPECT_TRUE(local_->move(1.0));
  ASSERT_TRUE(EventuallyTrue([&] { return recorder_->status().is_finished; }));
  EXPECT_TRUE(recorder_->Stop());

  EXPECT_EQ(CallsIn("run.mcap", "robot/lift/Control/Move"),
            std::vector{Executed("1", "pilot/Lift")});
}

TEST_F(RecordedCommands, OfTheOwnProcessNeedNoGcm) {
  StartRobot();
  queue_ = std::make_shared<RecordingQueue>();
  const auto system = std::make_shared<LocalSystem>(robot_->OpenLocalAccess(), queue_);
  auto recorder = Recorder::Start(
      system, queue_, {.patterns = {"robot/lift"}, .files = {.file = Path("run.mcap")}});
  ASSERT_TRUE(recorder) << recorder.error().message;
  recorder_ = *std::move(recorder);
  AwaitRecorder({"Stop"});

  EXPECT_TRUE(local_->stop());
  ASSERT_TRUE(EventuallyTrue([&] { return recorded() == 1; }));
  ASSERT_TRUE(recorder_->Stop());

  EXPECT_EQ(CallsIn("run.mcap", "robot/lift/Control/Stop").front(), Executed("", "pilot/Lift"));
}

TEST_F(RecordedCommands, AreExportedWithTheirClients) {
  StartRobot();
  StartRecorder("run.mcap", {.patterns = {"robot/lift/Control.*"}});
  AwaitRecorder({"Move", "Stop"});
  EXPECT_TRUE(local_->move(1.5));
  EXPECT_TRUE(local_->stop());
  ASSERT_TRUE(EventuallyTrue([&] { return recorded() == 2; }));
  ASSERT_TRUE(recorder_->Stop());
  const auto reader = mcap::Reader::Open(Path("run.mcap"));
  ASSERT_TRUE(reader);

  const auto report = ExportCsv(**reader, {}, Path("csv"));

  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->commands, 2U);
  const std::string csv = folder_.Read("csv/robot.lift.Control.Move.csv");
  EXPECT_THAT(csv.substr(0, csv.find('\n')), HasSubstr("argument"));
  EXPECT_THAT(csv, HasSubstr("pilot/Lift"));
  const std::string without_argument = folder_.Read("csv/robot.lift.Control.Stop.csv");
  EXPECT_THAT(without_argument.substr(0, without_argument.find('\n')),
              testing::Not(HasSubstr("argument")));
  EXPECT_THAT(without_argument, HasSubstr("pilot/Lift"));
}

}  // namespace
}  // namespace tendon::recording
