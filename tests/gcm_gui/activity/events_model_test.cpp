#include <gcm_gui/activity/events_model.h>
#include <gcm_gui/inspector/event_list.h>
#include <gcm_gui/models/row_roles.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QLabel>

#include "support/fakes.h"

namespace tendon::gui {
namespace {

constexpr std::int64_t kEventSecond = 1'000'000'000;

class EventsModelTest : public ::testing::Test {
 protected:
  QStringList Shown() const {
    QStringList paths;
    for (int row = 0; row < model_.rowCount(); ++row) {
      paths << model_.index(row).data(kPathRole).toString();
    }
    return paths;
  }

  EventsModel model_{3};
  QAbstractItemModelTester tester_{&model_};
};

TEST_F(EventsModelTest, ShowsTheNewestFirstAndDropsTheOldest) {
  model_.add({{1, "a/b/C.One", ""}, {2, "a/b/C.Two", ""}});
  model_.add({{3, "a/b/C.Three", ""}, {4, "a/b/C.Four", ""}});

  EXPECT_EQ(Shown(), (QStringList{"a/b/C.Four", "a/b/C.Three", "a/b/C.Two"}));
}

TEST_F(EventsModelTest, AcceptsOnlyEventsOfItsPart) {
  model_.setPart("a/b");
  model_.add({{1, "a/b/C.One", ""}, {2, "a/bad/C.Two", ""}});
  model_.addLost("a/bad/C.Two", 5);

  EXPECT_EQ(Shown(), QStringList{"a/b/C.One"});
  EXPECT_EQ(model_.lost(), 0U);
  EXPECT_EQ(model_.index(0).data(kTrailRole).toString(), "C");
}

TEST_F(EventsModelTest, EventsDuringAPauseAppearAfterIt) {
  model_.add({{1, "a/b/C.One", ""}});
  model_.setPaused(true);
  model_.add({{2, "a/b/C.Two", ""}});
  EXPECT_EQ(model_.rowCount(), 1);
  EXPECT_EQ(model_.waiting(), 1U);

  model_.setPaused(false);

  EXPECT_EQ(Shown(), (QStringList{"a/b/C.Two", "a/b/C.One"}));
}

TEST_F(EventsModelTest, ClearingTheFilterShowsAll) {
  model_.add({{1, "a/b/C.One", "{\"joint\":3}"}, {2, "a/b/C.Two", ""}});
  model_.setWords({"joint"});
  EXPECT_EQ(Shown(), QStringList{"a/b/C.One"});

  model_.setWords({});

  EXPECT_EQ(Shown().size(), 2);
}

TEST_F(EventsModelTest, AveragesTheRateOverTwoSeconds) {
  model_.add({{kEventSecond, "a/b/C.One", ""}, {5 * kEventSecond, "a/b/C.One", ""}});
  model_.add({{6 * kEventSecond, "a/b/C.One", ""}});

  EXPECT_DOUBLE_EQ(model_.rate(6 * kEventSecond), 1.0);
  EXPECT_DOUBLE_EQ(model_.rate(9 * kEventSecond), 0.0);
}

TEST(EventList, TheHeaderCountsEachShownEventAtOnce) {
  ScriptedReports reports;
  EventList list(reports);
  list.show("a/b");
  const QLabel& head = *list.findChild<QLabel*>("inspector.eventRate");

  Q_EMIT reports.eventsArrived({{1, "a/b/C.One", ""}});

  EXPECT_TRUE(head.text().startsWith("1 event")) << head.text().toStdString();
}

}  // namespace
}  // namespace tendon::gui
