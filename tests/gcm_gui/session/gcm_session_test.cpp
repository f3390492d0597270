#include <gcm_gui/session/gcm_session.h>
#include <gtest/gtest.h>
#include <support/plant.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/middleware/frame.h>
#include <tendon/middleware/loopback.h>
#include <tendon/process/membership_messages.h>
#include <tendon/process/process.h>

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <atomic>
#include <functional>
#include <optional>

namespace tendon::gui {
namespace {

constexpr int kSessionTimeout = 120'000;  // ms; bounds a test that fails

const InterfaceName kOperated{"desk", "operator", "Robot"};
const InterfaceName kPlantControl{"robot", "plant", "Control"};

/// A GCM and two processes with real components over loopback, and the window's session.
class GcmSessionTest : public ::testing::Test {
 protected:
  GcmSessionTest() {
    auto manager = GlobalManager::Start(
        Node(), {.address = "127.0.0.1:0", .state_folder = folder_.path().toStdString()});
    manager_ = std::move(*manager);
    StartRobot();
    desk_ = std::make_unique<Process>("desk", Options());
    desk_->Add<plant::Operator>("operator");
    (void)desk_->StartAll();
    session_ = std::make_unique<GcmSession>(Node(), manager_->address(), true);
  }

  std::shared_ptr<Middleware> Node() { return std::make_shared<LoopbackMiddleware>(network_); }
  ProcessOptions Options() { return {.middleware = Node(), .gcm = manager_->address()}; }

  void StartRobot() {
    robot_ = std::make_unique<Process>("robot", Options());
    robot_->Add<plant::Plant>("plant");
    (void)robot_->StartAll();
  }

  const Catalogue& Known() { return session_->store().catalogue(); }
  bool IsConnected() {
    const auto* connection = Known().FindConnection(kOperated);
    return connection != nullptr && connection->state == ConnectionState::kActive;
  }
  bool Eventually(const std::function<bool()>& holds) {
    return QTest::qWaitFor(holds, kSessionTimeout);
  }
  bool EverythingIsThere() {
    const auto is_active = [&](const char* process, const char* component) {
      const auto* found = Known().FindComponent(process, component);
      return found != nullptr && found->state == ComponentState::kActive;
    };
    return Eventually([&] { return is_active("robot", "plant") && is_active("desk", "operator"); });
  }

  QTemporaryDir folder_;
  std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  std::unique_ptr<GlobalManager> manager_;
  std::unique_ptr<Process> robot_;
  std::unique_ptr<Process> desk_;
  std::unique_ptr<GcmSession> session_;
};

TEST_F(GcmSessionTest, LoadsTheCatalogueByItself) {
  EXPECT_TRUE(EverythingIsThere());
  EXPECT_EQ(session_->link().state(), LinkState::State::kConnected);
}

TEST_F(GcmSessionTest, ConnectsDisconnectsAndUndoesWithoutWaiting) {
  ASSERT_TRUE(EverythingIsThere());

  session_->connectInterfaces(kOperated, kPlantControl);
  EXPECT_EQ(session_->activity().action(0).outcome, Action::Outcome::kRunning);
  EXPECT_TRUE(Eventually([&] { return IsConnected(); }));
  EXPECT_TRUE(Eventually([&] { return session_->activity().canUndo(0); }));

  session_->undo();
  EXPECT_TRUE(Eventually([&] { return Known().FindConnection(kOperated) == nullptr; }));
  EXPECT_TRUE(Eventually([&] { return session_->activity().action(1).undone; }));

  session_->disconnectInterface(kOperated);
  EXPECT_TRUE(Eventually(
      [&] { return session_->activity().action(0).outcome == Action::Outcome::kRefused; }));
  EXPECT_FALSE(session_->activity().action(0).refusal.isEmpty());
}

TEST_F(GcmSessionTest, UndoOfAnothersConnectNeedsASecondRequest) {
  ASSERT_TRUE(EverythingIsThere());
  GcmClient console(Node(), {.name = "gcm connect", .address = manager_->address()});
  ASSERT_TRUE(console.WaitUntilWatching().ok());
  std::atomic<bool> is_recorded = false;
  console.Connect(kOperated, kPlantControl, [&](const auto&) { is_recorded = true; });
  ASSERT_TRUE(Eventually([&] { return is_recorded && IsConnected(); }));

  session_->undo();
  ASSERT_TRUE(Eventually(
      [&] { return session_->activity().action(0).outcome == Action::Outcome::kRefused; }));
  const QString refusal = session_->activity().action(0).refusal;
  EXPECT_TRUE(refusal.contains("by gcm connect, ") && refusal.contains(" ago"))
      << refusal.toStdString();
  EXPECT_TRUE(IsConnected());

  session_->undo();
  EXPECT_TRUE(Eventually([&] { return Known().FindConnection(kOperated) == nullptr; }));
}

TEST_F(GcmSessionTest, UndoOfAnothersStopNeedsASecondRequest) {
  ASSERT_TRUE(EverythingIsThere());
  GcmClient console(Node(), {.name = "gcm stop", .address = manager_->address()});
  ASSERT_TRUE(console.WaitUntilWatching().ok());
  std::atomic<bool> is_stopped = false;
  console.ExecuteLifecycleOrder(
      {.verb = LifecycleVerb::kStop, .process = "robot", .component = "plant"},
      [&](const auto& result) { is_stopped = result.ok(); });
  ASSERT_TRUE(Eventually([&] { return is_stopped.load(); }));

  session_->undo();
  ASSERT_TRUE(Eventually(
      [&] { return session_->activity().action(0).outcome == Action::Outcome::kRefused; }));

  EXPECT_TRUE(session_->activity().action(0).refusal.contains("stop robot/plant"));
  EXPECT_TRUE(session_->activity().action(0).refusal.contains("can move something"));
  EXPECT_EQ(robot_->Find("plant")->state(), ComponentState::kFinished);
}

TEST_F(GcmSessionTest, FindsTheTypeOfACommandAndCallsIt) {
  ASSERT_TRUE(EverythingIsThere());
  const auto& commands = Known().FindProvided(kPlantControl)->commands;
  const auto move_to = std::find_if(commands.begin(), commands.end(),
                                    [](const auto& one) { return one.name == "MoveTo"; });
  ASSERT_NE(move_to, commands.end());
  std::optional<Schema> schema;
  session_->findSchema("robot", move_to->signature.in, [&](const auto& found) { schema = *found; });
  ASSERT_TRUE(Eventually([&] { return schema.has_value(); }));
  EXPECT_EQ(schema->TypeName(), "plant.Move");

  int replies = 0;
  session_->callCommand("robot/plant/Control.MoveTo", R"({"number":7,"goal":[1,2,3]})",
                        [&](const auto& reply, double) { replies += reply.ok() ? 1 : 0; });
  ASSERT_TRUE(Eventually([&] { return replies == 1; }));

  EXPECT_EQ(session_->activity().action(0).outcome, Action::Outcome::kDone);
  EXPECT_FALSE(session_->activity().canUndo(0));
  EXPECT_EQ(session_->activity().command(0),
            R"(gcm call robot/plant/Control.MoveTo '{"number":7,"goal":[1,2,3]}')");
  const auto* plant = static_cast<const plant::Plant*>(robot_->Find("plant"));
  EXPECT_TRUE(Eventually([&] { return plant->moves.size() == 1; }));
}

TEST_F(GcmSessionTest, TheActivityShowsARefusedCall) {
  ASSERT_TRUE(EverythingIsThere());
  std::optional<Error> refusal;

  session_->callCommand("robot/plant/Control.MoveTo", R"({"number":"x"})",
                        [&](const auto& reply, double) { refusal = reply.error(); });
  ASSERT_TRUE(Eventually([&] { return refusal.has_value(); }));

  EXPECT_EQ(session_->activity().action(0).outcome, Action::Outcome::kRefused);
  EXPECT_EQ(session_->activity().action(0).refusal, QString::fromStdString(refusal->message));
}

TEST_F(GcmSessionTest, ACallFailsWhenItsProcessIsLost) {
  session_ = std::make_unique<GcmSession>(Node(), manager_->address(), true, Role::kOperator,
                                          std::chrono::seconds(40));
  ASSERT_TRUE(EverythingIsThere());
  bool is_linked = false;
  session_->readValue("robot/plant/state.Move", [&](const auto&) { is_linked = true; });
  ASSERT_TRUE(Eventually([&] { return is_linked; }));
  const std::string robot = Known().FindProcess("robot")->process.address;
  network_->SetFaultInjector([robot](const loopback::Frame& frame) {
    const auto type = ReadFrameHeader(frame.bytes, frame.bytes.size())->type;
    const bool is_of_lease = type == message::kRenew || type == message::kJoin;
    const bool is_of_robot = frame.from == robot || frame.to == robot;
    return is_of_lease || is_of_robot ? loopback::kDrop : loopback::kPass;
  });
  std::optional<Error> told;

  session_->callCommand("robot/plant/Control.Stop", {},
                        [&](const auto& reply, double) { told = reply.error(); });
  ASSERT_TRUE(Eventually([&] { return told.has_value(); }));
  network_->SetFaultInjector(nullptr);

  EXPECT_EQ(told->code, ErrorCode::kTimeout);
  EXPECT_TRUE(told->message.starts_with("process 'robot' is lost")) << told->message;
  EXPECT_TRUE(told->message.ends_with(
      "it is unknown whether the command was executed or will still be executed: check the "
      "component before you repeat the call"))
      << told->message;
  EXPECT_EQ(session_->activity().action(0).outcome, Action::Outcome::kRefused);
}

TEST_F(GcmSessionTest, ReplacesAConnectionAndUndoesItInOneStep) {
  const InterfaceName other{"robot", "spare", "Control"};
  robot_->Add<plant::Plant>("spare");
  ASSERT_TRUE(EverythingIsThere());
  ASSERT_TRUE(Eventually([&] { return Known().FindProvided(other) != nullptr; }));
  const auto is_connected_to = [&](const InterfaceName& provided) {
    const auto* connection = Known().FindConnection(kOperated);
    return connection != nullptr && connection->provided == provided;
  };
  session_->connectInterfaces(kOperated, kPlantControl);
  ASSERT_TRUE(Eventually([&] { return session_->activity().canUndo(0); }));

  session_->connectOrReplace(kOperated, other);
  EXPECT_TRUE(Eventually([&] { return is_connected_to(other); }));
  EXPECT_TRUE(Eventually([&] { return session_->activity().canUndo(0); }));
  EXPECT_EQ(session_->activity().action(0).verb, Action::Verb::kReplace);

  session_->undo();
  EXPECT_TRUE(Eventually([&] { return is_connected_to(kPlantControl); }));
  EXPECT_TRUE(Eventually([&] { return session_->activity().action(1).undone; }));
}

TEST_F(GcmSessionTest, NothingIsReplacedIfTheInterfaceIsNotConnected) {
  ASSERT_TRUE(EverythingIsThere());

  session_->connectOrReplace(kOperated, kPlantControl);

  EXPECT_TRUE(Eventually([&] { return IsConnected(); }));
  EXPECT_EQ(session_->activity().action(0).verb, Action::Verb::kConnect);
}

TEST_F(GcmSessionTest, ARefusedReplacementKeepsTheConnection) {
  ASSERT_TRUE(EverythingIsThere());
  session_->connectInterfaces(kOperated, kPlantControl);
  ASSERT_TRUE(Eventually([&] { return session_->activity().canUndo(0); }));

  session_->connectOrReplace(kOperated, {"robot", "plant", "NoSuchInterface"});

  EXPECT_TRUE(Eventually(
      [&] { return session_->activity().action(0).outcome == Action::Outcome::kRefused; }));
  EXPECT_TRUE(Eventually([&] { return IsConnected(); }));
}

TEST_F(GcmSessionTest, DeliversEveryRowOfASignalOnce) {
  ASSERT_TRUE(EverythingIsThere());
  std::vector<Sample> rows;
  QObject::connect(&session_->liveSignals(), &SignalSource::samplesArrived, session_.get(),
                   [&](const QString&, std::span<const Sample> samples) {
                     rows.insert(rows.end(), samples.begin(), samples.end());
                   });

  session_->liveSignals().subscribe("robot/plant/state.Move.goal[0]");
  ASSERT_TRUE(Eventually([&] { return rows.size() > 1000; }));

  for (std::size_t i = 1; i < rows.size(); ++i) ASSERT_EQ(rows[i].tick, rows[i - 1].tick + 1);
}

TEST_F(GcmSessionTest, RowsResumeWhenALostProcessReturns) {
  ASSERT_TRUE(EverythingIsThere());
  QStringList heard;
  auto& live = session_->liveSignals();
  QObject::connect(&live, &SignalSource::samplesArrived, &live, [&] { heard << "rows"; });
  QObject::connect(&live, &SignalSource::wentStale, &live, [&] { heard << "stale"; });
  live.subscribe("robot/plant/state.Move.goal[0]");
  ASSERT_TRUE(Eventually([&] { return heard.contains("rows"); }));

  robot_.reset();
  EXPECT_TRUE(Eventually([&] { return heard.contains("stale"); }));
  EXPECT_TRUE(Eventually([&] {
    const auto* robot = Known().FindProcess("robot");
    return robot != nullptr && robot->process.state != ProcessState::kAlive;
  }));
  heard.clear();
  StartRobot();

  EXPECT_TRUE(Eventually([&] { return heard.contains("rows"); }));
}

TEST_F(GcmSessionTest, ReconnectsToALostGcm) {
  ASSERT_TRUE(EverythingIsThere());
  const std::string address = manager_->address();

  manager_.reset();
  EXPECT_TRUE(Eventually([&] { return session_->link().state() == LinkState::State::kLost; }));
  EXPECT_NE(Known().FindProvided(kPlantControl), nullptr);  // the known state is kept

  auto manager = GlobalManager::Start(
      Node(), {.address = address, .state_folder = folder_.path().toStdString()});
  ASSERT_TRUE(manager) << manager.error().message;
  manager_ = std::move(*manager);
  EXPECT_TRUE(Eventually([&] { return session_->link().state() == LinkState::State::kConnected; }));
  EXPECT_TRUE(EverythingIsThere());
}

TEST_F(GcmSessionTest, CanBeDestroyedDuringARequest) {
  ASSERT_TRUE(EverythingIsThere());

  session_->connectInterfaces(kOperated, kPlantControl);
  session_.reset();

  QTest::qWait(50);  // a late reply would arrive now
}

}  // namespace
}  // namespace tendon::gui
