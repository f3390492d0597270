#include <gcm_gui/plot/plot_files.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gmock/gmock.h>

#include <QApplication>
#include <QFile>
#include <QFileDialog>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "samples.h"

namespace tendon::gui {
namespace {

constexpr int kTestTimeout = 120'000;  // ms; bounds a test that fails
const QString kSignalX = "robot/arm/state.x";

class PlotFilesTest : public testing::Test {
 protected:
  PlotFilesTest() {
    panel_.resize(800, 320);
    panel_.show();
  }

  [[nodiscard]] QFileDialog* Ask() {
    QTest::mouseClick(panel_.findChild<QToolButton*>("saveCsv"), Qt::LeftButton);
    return panel_.findChild<QFileDialog*>();
  }

  QTemporaryDir folder_;
  PlotPanel panel_;
  QSignalSpy notices_{&panel_, &PlotPanel::notice};
};

TEST_F(PlotFilesTest, SavesTheVisibleSamplesToTheChosenFile) {
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  panel_.addSignal(kSignalX, "rad");
  panel_.append(kSignalX, Rows(0, 1000));
  panel_.currentPlot().refresh();
  QFileDialog* dialog = Ask();
  ASSERT_NE(dialog, nullptr);
  const QString file = folder_.filePath("arm.csv");

  dialog->selectFile(file);
  QMetaObject::invokeMethod(dialog, "accept");

  ASSERT_TRUE(QTest::qWaitFor([&] { return !notices_.isEmpty(); }, kTestTimeout));
  EXPECT_EQ(notices_.front().front().toString(), "Saved 1000 rows, none lost, to " + file);
  QFile saved(file);
  ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
  EXPECT_EQ(saved.readAll().count('\n'), 1001);
}

TEST_F(PlotFilesTest, DoesNotAskForAFileWithoutSamples) {
  EXPECT_EQ(Ask(), nullptr);

  ASSERT_EQ(notices_.size(), 1);
  EXPECT_TRUE(notices_.front().front().toString().startsWith("There is nothing to save"));
}

TEST_F(PlotFilesTest, SavesAndOpensALayoutAndReportsAMissingFile) {
  const QString file = folder_.filePath("mine.plots.json");
  panel_.addSignal(kSignalX, "rad");
  panel_.files().saveLayout(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return notices_.count() == 1; }, kTestTimeout));
  EXPECT_EQ(notices_[0][0].toString(), file + " saved");
  PlotPanel other;
  other.files().openLayout(file);
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return other.paths() == QStringList{kSignalX}; }, kTestTimeout));

  QSignalSpy notice(&other, &PlotPanel::notice);
  other.files().openLayout(folder_.filePath("none"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return notice.count() == 1; }, kTestTimeout));
  EXPECT_THAT(notice[0][0].toString().toStdString(), testing::HasSubstr("cannot be read"));
}

}  // namespace
}  // namespace tendon::gui
