#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/recording/recording_strip.h>
#include <gcm_gui/recording/window_recording.h>
#include <gcm_gui/session/gcm_session.h>
#include <gcm_gui/window/main_window.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/middleware/loopback.h>
#include <tendon/payload/codec.h>
#include <tendon/process/process.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/mcap/verify.h>
#include <tendon/recording/recording_format.h>
#include <tendon/task/periodic_task.h>

#include <QAbstractButton>
#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;
using State = RecordingController::State;

constexpr int kRecordingTimeout = 120'000;  // ms; bounds a test that fails

/// Counts its cycles in a table with two columns, and raises an event at each hundredth one.
class Counter final : public PeriodicTask {
 public:
  explicit Counter(std::string name) : PeriodicTask(std::move(name), 1ms) {
    state_table().Add(number_, "Number");
    state_table().Add(half_, "Half");
    AddProvidedInterface("Control").AddEvent(passed_, "Passed");
  }
  ~Counter() override { Join(); }

  void Run() override {
    half_ = 0.5 * static_cast<double>(++number_);
    if (number_ % 100 == 0) passed_(number_);
  }

 private:
  std::uint64_t number_ = 0;
  double half_ = 0.0;
  WriteEvent<std::uint64_t> passed_;
};

/// The real window with a real GCM and a process at 1 kHz, in this process.
class RecordingWorkerTest : public ::testing::Test {
 protected:
  RecordingWorkerTest() {
    StartGcm("127.0.0.1:0");
    StartRobot();
    session_ = std::make_unique<GcmSession>(Node(), address_, false, Role::kOperator, 20s);
    window_ = std::make_unique<MainWindow>(PartsOf(*session_));
    window_->show();
    window_->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(window_.get(), kRecordingTimeout));
    Controller().setFolder(folder_.filePath("recordings"));
    EXPECT_TRUE(Eventually([this] {
      return session_->store().catalogue().FindComponent("robot", "counter") != nullptr;
    }));
  }

  std::shared_ptr<Middleware> Node() { return std::make_shared<LoopbackMiddleware>(network_); }
  void StartGcm(const std::string& address) {
    auto gcm = GlobalManager::Start(
        Node(), {.address = address, .state_folder = folder_.path().toStdString()});
    ASSERT_TRUE(gcm) << gcm.error().message;
    gcm_ = *std::move(gcm);
    address_ = gcm_->address();
  }
  void StartRobot() {
    robot_ =
        std::make_unique<Process>("robot", ProcessOptions{.middleware = Node(), .gcm = address_});
    robot_->Add<Counter>("counter");
    EXPECT_TRUE(robot_->StartAll());
  }
  static bool Eventually(const std::function<bool()>& holds) {
    return QTest::qWaitFor(holds, kRecordingTimeout);
  }

  RecordingController& Controller() { return window_->recording().controller(); }
  [[nodiscard]] std::uint64_t Rows() { return Controller().progress().status.counts.rows; }
  void Click(const char* name) {
    auto* button = window_->findChild<QAbstractButton*>(QString::fromLatin1(name));
    ASSERT_NE(button, nullptr) << name;
    QTest::mouseClick(button, Qt::LeftButton);
  }
  /// Records everything, and waits until some rows are recorded.
  void RecordEverything() {
    Controller().setScope(RecordingScope::kEverything);
    Click("record");
    ASSERT_TRUE(Eventually([this] { return Rows() > 100; })) << Reason();
  }
  void Stop() {
    Click("stopRecording");
    ASSERT_TRUE(Eventually([this] { return Controller().state() == State::kIdle; }));
  }
  std::string Reason() {
    const auto& report = Controller().report();
    return report ? (report->title + ": " + report->detail).toStdString() : "no report";
  }
  [[nodiscard]] QStringList Files() const {
    return QDir(folder_.filePath("recordings")).entryList({"*.mcap"}, QDir::Files);
  }
  /// Returns the number of messages by topic. The file must be complete.
  static std::map<std::string, std::uint64_t> TopicsOf(const QString& file) {
    std::map<std::string, std::uint64_t> counts;
    for (const auto& [topic, bodies] : BodiesOf(file)) counts[topic] = bodies.size();
    return counts;
  }
  /// Returns the numbers on a topic.
  static std::vector<std::uint64_t> NumbersIn(const QString& file, const std::string& topic) {
    std::vector<std::uint64_t> numbers;
    auto topics = BodiesOf(file);
    for (const auto& body : topics[topic]) {
      EXPECT_TRUE(Decode(body, numbers.emplace_back()));
    }
    return numbers;
  }
  /// Returns the values of the messages by topic. The file must be complete.
  static std::map<std::string, std::vector<std::vector<std::byte>>> BodiesOf(const QString& file) {
    std::map<std::string, std::vector<std::vector<std::byte>>> topics;
    const auto reader = mcap::Reader::Open(file.toStdString());
    EXPECT_TRUE(reader) << reader.error().message;
    if (!reader) return topics;
    EXPECT_FALSE((*reader)->was_scanned()) << "the file has no index";
    EXPECT_EQ(tendon::mcap::Verify(**reader).problems.count(), 0U);
    auto messages = (*reader)->Messages({});
    while (const auto message = messages.Next()) {
      const auto body = recording::BodyOf(message->data);
      topics[(*reader)->FindChannel(message->channel_id)->topic].emplace_back(body.begin(),
                                                                              body.end());
    }
    return topics;
  }

  const QTemporaryDir folder_;
  const std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  std::unique_ptr<GlobalManager> gcm_;
  std::string address_;
  std::unique_ptr<Process> robot_;
  std::unique_ptr<GcmSession> session_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(RecordingWorkerTest, TheFileHoldsThePlottedColumn) {
  window_->plots().addSignal(QStringLiteral("robot/counter/state.Number"), {});

  QTest::keyClick(window_.get(), Qt::Key_R, Qt::ControlModifier);
  ASSERT_TRUE(Eventually([this] { return Rows() > 300; })) << Reason();
  EXPECT_GT(Controller().progress().status.disk_free, 0U);
  QTest::keyClick(window_.get(), Qt::Key_R, Qt::ControlModifier);
  ASSERT_TRUE(Eventually([this] { return Controller().state() == State::kIdle; }));

  ASSERT_EQ(Controller().report()->kind, RecordingReport::Kind::kDone) << Reason();
  auto topics = TopicsOf(Controller().file());
  EXPECT_EQ(topics["robot/counter/state/Number"], Rows());
  EXPECT_FALSE(topics.contains("robot/counter/state/Half")) << "nobody plots it";
  EXPECT_EQ(session_->activity().command(0),
            "gcm record robot/counter/state.Number -o '" + Controller().file() + "'");
}

TEST_F(RecordingWorkerTest, ASecondRecordingGetsAFileOfItsOwn) {
  RecordEverything();
  Stop();
  const QString first = Controller().file();
  RecordEverything();
  Stop();

  EXPECT_NE(Controller().file(), first);
  EXPECT_EQ(Files().size(), 2);
}

TEST_F(RecordingWorkerTest, TheLastSecondsAreInTheFileAndTheReportCountsThem) {
  const QString column = QStringLiteral("robot/counter/state.Number");
  window_->plots().addSignal(column, {});
  const SampleRing& shown = window_->plots().plot(0).curve(column)->samples();
  ASSERT_TRUE(Eventually([&] { return shown.endIndex() > 500; }));
  const double oldest = shown.value(shown.firstIndex());
  const double newest = shown.value(shown.endIndex() - 1);
  window_->selection().select(QStringLiteral("robot/counter"));
  Controller().setScope(RecordingScope::kSelected);

  QTest::keyClick(window_.get(), Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(Eventually([this] { return Controller().report().has_value(); }));

  const RecordingReport report = *Controller().report();
  ASSERT_EQ(report.kind, RecordingReport::Kind::kDone) << Reason();
  EXPECT_EQ(Controller().state(), State::kIdle);
  EXPECT_EQ(report.file, Controller().file());
  auto topics = TopicsOf(report.file);
  const auto numbers = NumbersIn(report.file, "robot/counter/state/Number");
  ASSERT_FALSE(numbers.empty());
  EXPECT_EQ(topics["robot/counter/state/Half"], numbers.size());
  EXPECT_LE(static_cast<double>(numbers.front()), oldest) << "from before the plot";
  EXPECT_GE(static_cast<double>(numbers.back()), newest);
  EXPECT_TRUE(std::ranges::is_sorted(numbers));
  if (numbers.back() - numbers.front() + 1 > numbers.size()) {
    EXPECT_TRUE(report.detail.contains(" lost")) << "a gap must be told: " << Reason();
  }
  const auto events = NumbersIn(report.file, "robot/counter/Control/Passed");
  ASSERT_GE(events.size(), 2U);
  for (std::size_t i = 1; i < events.size(); ++i) EXPECT_EQ(events[i], events[i - 1] + 100);
  EXPECT_TRUE(report.title.startsWith(QStringLiteral("Saved the last 30 s: %1 rows, %2 events (")
                                          .arg(numbers.size())
                                          .arg(events.size())))
      << Reason();
  if (std::chrono::steady_clock::now() - began_ < 30s) {  // or the process is old enough by now
    EXPECT_TRUE(report.detail.contains("it has not been running longer")) << Reason();
  }
  EXPECT_EQ(session_->activity().command(0),
            "gcm save-last 30s robot/counter -o '" + report.file + "'");
  EXPECT_GT(session_->activity().action(0).seconds, 0.0) << "the duration of the saving";
}

TEST_F(RecordingWorkerTest, IfNothingCanBeSavedTheReportSaysSoAndNoFileRemains) {
  window_->selection().select(QStringLiteral("robot/nobody"));
  Controller().setScope(RecordingScope::kSelected);

  QTest::keyClick(window_.get(), Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(Eventually([this] { return Controller().report().has_value(); }));

  EXPECT_EQ(Controller().report()->kind, RecordingReport::Kind::kFailed);
  EXPECT_EQ(Controller().report()->title, "Nothing is saved");
  EXPECT_EQ(Controller().report()->detail, "no state table and no event matches these paths");
  EXPECT_TRUE(Files().isEmpty());
}

TEST_F(RecordingWorkerTest, TheEndOfTheWindowCompletesTheFile) {
  RecordEverything();
  const QString file = Controller().file();

  window_->close();
  window_.reset();
  session_.reset();

  EXPECT_GT(TopicsOf(file)["robot/counter/state/Number"], 100U);
}

TEST_F(RecordingWorkerTest, ALostGcmIsToldAndEndsNoRecording) {
  RecordEverything();

  gcm_.reset();
  ASSERT_TRUE(Eventually([this] { return !Controller().interruptions().isEmpty(); }));
  const std::uint64_t before = Rows();
  ASSERT_TRUE(Eventually([&] { return Rows() > before + 500; }));
  StartGcm(address_);
  ASSERT_TRUE(Eventually([this] {
    return Controller().interruptions().contains(QStringLiteral("the GCM is available again"));
  }));
  Stop();

  EXPECT_EQ(Controller().report()->kind, RecordingReport::Kind::kDone) << Reason();
  EXPECT_GT(TopicsOf(Controller().file())["robot/counter/state/Number"], before + 500);
}

TEST_F(RecordingWorkerTest, ALostProcessIsToldAndRecordedAgainWhenItIsBack) {
  RecordEverything();

  robot_.reset();
  ASSERT_TRUE(Eventually([this] { return !Controller().interruptions().isEmpty(); }));
  EXPECT_EQ(Controller().state(), State::kRecording);
  const std::uint64_t before = Rows();
  StartRobot();
  ASSERT_TRUE(Eventually([&] { return Rows() > before + 500; }));
  Stop();

  EXPECT_EQ(Controller().report()->kind, RecordingReport::Kind::kDone) << Reason();
}

TEST_F(RecordingWorkerTest, AFolderThatCannotBeMadeIsSaidInTheStrip) {
  ASSERT_TRUE(QFile(folder_.filePath("file")).open(QIODevice::WriteOnly));
  Controller().setFolder(folder_.filePath("file/recordings"));
  Controller().setScope(RecordingScope::kEverything);

  Click("record");
  ASSERT_TRUE(Eventually([this] { return Controller().report().has_value(); }));

  const QString text = window_->recording().strip().text();
  EXPECT_TRUE(window_->recording().strip().isVisible());
  EXPECT_TRUE(text.contains("Nothing is recorded")) << text.toStdString();
  EXPECT_TRUE(text.contains("file/recordings cannot be created: Not a directory"))
      << text.toStdString();
}

TEST_F(RecordingWorkerTest, AMissingGcmIsSaidInTheStrip) {
  GcmSession lonely(Node(), "127.0.0.1:1", false, Role::kOperator, 200ms);
  MainWindow window(PartsOf(lonely));
  RecordingController& controller = window.recording().controller();
  controller.setFolder(folder_.filePath("recordings"));
  controller.setScope(RecordingScope::kEverything);

  controller.start();
  EXPECT_EQ(controller.state(), State::kStarting);
  ASSERT_TRUE(Eventually([&] { return controller.report().has_value(); }));

  EXPECT_TRUE(controller.report()->detail.startsWith("no GCM at 127.0.0.1:1"))
      << controller.report()->detail.toStdString();
  EXPECT_TRUE(Files().isEmpty());
}

/// The system refuses to let any file of this program grow further.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TEST_F(RecordingWorkerTest, ADiskThatTakesNoMoreEndsTheRecordingWithAReason) {
  RecordEverything();
  {
    const FullDisk disk(20'000);
    ASSERT_TRUE(Eventually([this] { return Controller().state() == State::kIdle; }));
  }

  EXPECT_EQ(Controller().report()->kind, RecordingReport::Kind::kFailed);
  EXPECT_TRUE(Controller().report()->detail.contains("File too large")) << Reason();
  EXPECT_EQ(session_->activity().action(0).outcome, Action::Outcome::kRefused);
  EXPECT_TRUE(mcap::Reader::Open(Controller().file().toStdString()));
}

}  // namespace
}  // namespace tendon::gui
