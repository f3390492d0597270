#include <gcm_gui/plot/controls/legend.h>
#include <gmock/gmock.h>

#include <QApplication>
#include <QKeyEvent>
#include <QSignalSpy>
#include <QTest>

namespace tendon::gui {
namespace {

LegendEntry Entry(const QString& path, const QString& value) {
  return {.path = path, .name = path, .value = value, .unit = "rad"};
}

TEST(Legend, HasAnAccessibleRowForEachCurve) {
  Legend legend(nullptr);

  legend.setEntries({Entry("x", "0.201"), Entry("y", "-0.399")});

  ASSERT_EQ(legend.rows().size(), 2U);
  EXPECT_EQ(legend.rows()[1]->accessibleName(), "y -0.399 rad");
  EXPECT_EQ(legend.rows()[1]->objectName(), "legend:y");
}

TEST(Legend, KeepsItsWidthWhenNumbersBecomeShorter) {
  Legend legend(nullptr);
  legend.setEntries({Entry("x", "-10.201")});
  const QSize size = legend.size();

  legend.setEntries({Entry("x", "0.2")});

  EXPECT_EQ(legend.size(), size);
}

TEST(Legend, TheCrossAndTheDeleteKeyRemoveACurve) {
  Legend legend(nullptr);
  legend.setEntries({Entry("x", "1"), Entry("y", "2")});
  QSignalSpy removed(&legend, &Legend::removeRequested);
  LegendRow* row = legend.rows()[0];

  QTest::mouseClick(row, Qt::LeftButton, {}, QPoint(6, row->height() / 2));
  QTest::keyClick(legend.rows()[1], Qt::Key_Delete);

  ASSERT_EQ(removed.count(), 2);
  EXPECT_EQ(removed[0][0], "x");
  EXPECT_EQ(removed[1][0], "y");
}

TEST(Legend, AClickOnTheRowHidesTheCurve) {
  Legend legend(nullptr);
  legend.setEntries({Entry("x", "1")});
  QSignalSpy toggled(&legend, &Legend::toggled);

  QTest::mouseClick(legend.rows()[0], Qt::LeftButton, {}, QPoint(40, 9));

  ASSERT_EQ(toggled.count(), 1);
  EXPECT_EQ(toggled[0][0], "x");
}

TEST(Legend, AFocusedRowOverridesShortcutsOfTheWindow) {
  Legend legend(nullptr);
  legend.setEntries({Entry("x", "1")});
  QKeyEvent space(QEvent::ShortcutOverride, Qt::Key_Space, Qt::NoModifier);
  QKeyEvent letter(QEvent::ShortcutOverride, Qt::Key_P, Qt::NoModifier);
  space.ignore();
  letter.ignore();

  QApplication::sendEvent(legend.rows()[0], &space);
  QApplication::sendEvent(legend.rows()[0], &letter);

  EXPECT_TRUE(space.isAccepted());
  EXPECT_FALSE(letter.isAccepted());
}

TEST(Legend, AStaleRowNamesItsSource) {
  Legend legend(nullptr);

  legend.setEntries(
      {{.path = "p/a/state.x", .name = "a.x · waiting for p/a/state", .stale = true}});

  EXPECT_EQ(legend.rows()[0]->accessibleName(), "a.x · waiting for p/a/state");
}

TEST(LegendValue, HasTwoDigitsMoreThanTheAxis) {
  EXPECT_EQ(LegendValue(0.2013, {.low = -1.5, .high = 1.5}), "0.201");
  EXPECT_EQ(LegendValue(73.26, {.low = 0, .high = 100}), "73.3");
  EXPECT_EQ(LegendValue(2.5e9, {.low = 0, .high = 3e9}), "2.5e+09");
}

}  // namespace
}  // namespace tendon::gui
