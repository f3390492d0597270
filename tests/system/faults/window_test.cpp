#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "support/program.h"
#include "system/faults/harness/fault_test.h"
#include "system/faults/harness/footprint.h"

namespace faults {
namespace {

using nlohmann::json;

const std::string kNumbers = "robot/ledger/state.Sample.number";

/// The program `gcm-gui` without a screen, and its description of its own state.
class Window {
 public:
  Window(const Program::Words& command, const std::map<std::string, std::string>& environment,
         std::string description)
      : program_(command, environment), description_(std::move(description)) {}

  void Signal(int signal) const { program_.Signal(signal); }
  [[nodiscard]] std::string err() const { return program_.err(); }

  /// Returns the number of received rows of the plotted number.
  [[nodiscard]] std::uint64_t rows() const {
    const json facts = Describe().value("facts", json::object());
    const json curve = facts.value("curves", json::object()).value(kNumbers, json::object());
    return static_cast<std::uint64_t>(curve.value("rows", 0.0));
  }

  /// Returns the names of the components and connections in its graph.
  [[nodiscard]] std::set<std::string> graph() const {
    const json all = Describe();
    const json nodes = all.value("nodes", json::object());
    const json facts = all.value("facts", json::object());
    const json connections = facts.value("connections", json::object());
    std::set<std::string> names;
    for (const auto& node : nodes.items()) names.insert(node.key());
    for (const auto& connection : connections.items()) {
      names.insert(connection.key() + " -> " + connection.value().value("provided", "") + ' ' +
                   connection.value().value("state", ""));
    }
    return names;
  }

 private:
  [[nodiscard]] json Describe() const {
    std::ifstream file(description_);
    const json all = json::parse(file, nullptr, false);
    return all.is_object() ? all : json::object();
  }

  Program program_;
  const std::string description_;
};

class WindowFault : public FaultTest {
 protected:
  /// Opens a window that plots the ledger's samples.
  [[nodiscard]] std::unique_ptr<Window> OpenWindow() {
    const std::string number = std::to_string(++windows_);
    const std::string description = home_.path() / ("window" + number + ".json");
    home_.Write("plots.json", R"({"version": 1, "plots": [{"window": 10, "curves": [{"path": ")" +
                                  kNumbers + R"(", "unit": ""}]}]})");
    auto with_platform = environment();
    with_platform["QT_QPA_PLATFORM"] = "offscreen";
    return std::make_unique<Window>(
        Words{Built("bin/gcm-gui"), "--gcm", gcm_address_, "--middleware", GetParam(), "--no-tour",
              "--layout", home_.path() / "plots.json", "--describe-ui", description},
        with_platform, description);
  }

  /// Returns true when the graph is complete and the plot receives new rows.
  [[nodiscard]] static bool Shows(const Window& window) {
    const std::uint64_t before = window.rows();
    return Eventually([&] { return window.rows() >= before + kRows; }) &&
           Eventually([&] { return window.graph() == Whole(); });
  }

  static std::set<std::string> Whole() {
    return {"robot/ledger", "desk/client", "desk/client/Ledger -> robot/ledger/Control active"};
  }

  /// Waits until the robot has no more descriptors than before the window was opened.
  [[nodiscard]] bool EventuallyReleases(const Footprint& before) const {
    return Eventually([&] { return FootprintOf(robot_->pid()).descriptors <= before.descriptors; });
  }

  static constexpr std::uint64_t kRows = 100;

 private:
  int windows_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Over, WindowFault, testing::ValuesIn(Middlewares()), NameOfMiddleware);

TEST_P(WindowFault, AKilledWindowHarmsNoOtherAndTheNextShowsAll) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  const Footprint before = FootprintOf(robot_->pid());
  auto window = OpenWindow();
  ASSERT_TRUE(Shows(*window)) << window->err();
  EXPECT_GT(FootprintOf(robot_->pid()).descriptors, before.descriptors);

  window->Signal(SIGKILL);
  const Stopwatch since_kill;
  EXPECT_TRUE(EventuallyReleases(before));
  const long released = since_kill.milliseconds();
  EXPECT_TRUE(Flows());

  const Stopwatch since_start;
  window = OpenWindow();
  EXPECT_TRUE(Shows(*window)) << window->err();
  Tell("killed: released after " + std::to_string(released) + " ms; the next is whole after " +
       std::to_string(since_start.milliseconds()) + " ms; " + ToString(stream_->verdict()));
  ExpectNoRowLost();
  ExpectNeverLost("robot");
  ExpectHonestCommands();
}

/// The window hangs. Its subscriptions are ended as after a kill, and it recovers when it runs
/// again.
TEST_P(WindowFault, AHangingWindowIsReleasedAndRecovers) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  const Footprint alone = FootprintOf(robot_->pid());
  const auto window = OpenWindow();
  ASSERT_TRUE(Shows(*window)) << window->err();

  window->Signal(SIGSTOP);
  const Stopwatch since_stop;
  EXPECT_TRUE(EventuallyReleases(alone));
  const long released = since_stop.milliseconds();
  ASSERT_TRUE(Flows(kRows));
  const Footprint before = FootprintOf(robot_->pid());
  ASSERT_TRUE(Flows(static_cast<std::uint64_t>(Size(2, 60)) * 1000));
  const Footprint after = FootprintOf(robot_->pid());
  EXPECT_TRUE(IsFlat(before, after)) << before << "; later " << after;
  const auto other = OpenWindow();
  EXPECT_TRUE(Shows(*other)) << other->err();

  window->Signal(SIGCONT);
  EXPECT_TRUE(Shows(*window)) << window->err();
  Tell("hung: released after " + std::to_string(released) + " ms; " + ToString(stream_->verdict()));
  ExpectNoRowLost();
  ExpectNeverLost("robot");
  ExpectHonestCommands();
}

}  // namespace
}  // namespace faults
