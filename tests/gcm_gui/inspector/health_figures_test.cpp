#include <gcm_gui/inspector/health_figures.h>
#include <gtest/gtest.h>

#include <QTest>
#include <algorithm>
#include <chrono>

#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {
namespace {

/// The figures of a process, which are asked for every second.
class HealthFiguresTest : public testing::Test {
 protected:
  HealthFiguresTest() {
    store_.replace(SystemBuilder().Process("robot").catalogue());
    message::SystemHealth health;
    health.processes.push_back({.process = "robot", .instance = 1});
    reports_.health = health;
  }
  [[nodiscard]] bool ShowsHistory() const {
    const auto facts = figures_.processFacts();
    return std::any_of(facts.begin(), facts.end(),
                       [](const Property& fact) { return fact.name == "History"; });
  }
  [[nodiscard]] bool IsAskedAgain() {
    return QTest::qWaitFor([this] { return reports_.health_questions > 1; }, 120'000);
  }

  CatalogueStore store_;
  ScriptedReports reports_;
  HealthFigures figures_{reports_, store_};
};

TEST_F(HealthFiguresTest, ShowTheHistoryOfTheProcess) {
  reports_.history = message::ProcessHistoryState{.limit = 1, .span = std::chrono::seconds(30)};

  figures_.show("robot", "");

  EXPECT_TRUE(ShowsHistory());
  ASSERT_TRUE(IsAskedAgain());
  EXPECT_GT(reports_.history_questions, 1);
}

TEST_F(HealthFiguresTest, ShowNoHistoryIfTheProcessDoesNotAnswer) {
  reports_.history = Error{ErrorCode::kTimeout, "process 'robot' does not answer"};

  figures_.show("robot", "");

  ASSERT_TRUE(IsAskedAgain());
  EXPECT_FALSE(ShowsHistory());
}

}  // namespace
}  // namespace tendon::gui
