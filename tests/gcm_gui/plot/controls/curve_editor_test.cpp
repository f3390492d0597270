#include <gcm_gui/plot/controls/curve_editor.h>
#include <gcm_gui/plot/controls/legend.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/theme/theme.h>
#include <gmock/gmock.h>

#include <QComboBox>
#include <QContextMenuEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QTest>
#include <cmath>

#include "../samples.h"

namespace tendon::gui {
namespace {

const QString kJoint = "robot/arm/state.Joints.position[0]";
const QString kSpeed = "robot/arm/state.Joints.velocity[0]";

/// Opens the editor from the legend with keys, as a user does.
class CurveEditorTest : public testing::Test {
 protected:
  CurveEditorTest() {
    view_.addCurve({kJoint, "rad"}).append(Rows(0, 30'000, [](double t) {
      return 1e-3 * std::sin(t);
    }));
    view_.addCurve({kSpeed, "rad/s"}).append(Rows(0, 30'000, [](double t) { return std::cos(t); }));
    ShowView(view_);
  }
  ~CurveEditorTest() override { Theme::instance().choose(Theme::Choice::kSystem); }

  [[nodiscard]] LegendRow& row() { return *view_.legendBox().rows().front(); }
  [[nodiscard]] CurveEditor& Open() {
    QTest::keyClick(&row(), Qt::Key_Return);
    return *view_.findChild<CurveEditor*>();
  }
  static void Type(CurveEditor& editor, const char* field, const QString& text) {
    auto* line = editor.findChild<QLineEdit*>(field);
    line->selectAll();
    QTest::keyClick(line, Qt::Key_Delete);
    QTest::keyClicks(line, text);
  }
  static QString Status(const CurveEditor& editor) {
    return editor.findChild<QLabel*>("curveEditor.status")->text();
  }
  [[nodiscard]] const CurveLook& look() const { return view_.curve(kJoint)->look(); }

  PlotView view_;
};

TEST_F(CurveEditorTest, EnterOpensTheEditorAndAcceptsIt) {
  CurveEditor& editor = Open();
  EXPECT_TRUE(editor.isVisible());

  Type(editor, "curveEditor.factor", "1000");
  Type(editor, "curveEditor.offset", "2");
  EXPECT_EQ(Status(editor), "Shown: value ×1000 +2, rad");
  QTest::keyClick(editor.findChild<QLineEdit*>("curveEditor.offset"), Qt::Key_Return);

  EXPECT_EQ(look(), (CurveLook{.scaling = {.factor = 1000, .offset = 2}}));
  view_.refresh();
  EXPECT_THAT(row().accessibleName().toStdString(), testing::EndsWith("rad ×1000 +2"));
  EXPECT_FALSE(editor.isVisible());
}

TEST_F(CurveEditorTest, AnAxisCanBeChosenOrNamed) {
  CurveEditor& editor = Open();
  auto* axis = editor.findChild<QComboBox*>("curveEditor.axis");
  EXPECT_EQ(axis->itemText(2), "rad/s");

  axis->setCurrentIndex(2);
  QTest::keyClick(axis->lineEdit(), Qt::Key_Return);

  EXPECT_EQ(look().axis, "rad/s");
  EXPECT_EQ(view_.curves().axes().size(), 1U);
}

TEST_F(CurveEditorTest, RejectsInvalidInputWithAReason) {
  CurveEditor& editor = Open();

  Type(editor, "curveEditor.factor", "fast");
  EXPECT_EQ(Status(editor), "The scale “fast” is not a number");
  EXPECT_FALSE(editor.findChild<QPushButton*>("curveEditor.accept")->isEnabled());
  QTest::keyClick(&editor, Qt::Key_Return);
  EXPECT_TRUE(editor.isVisible());
  Type(editor, "curveEditor.factor", "0");
  EXPECT_THAT(Status(editor).toStdString(), testing::HasSubstr("flat line"));

  QTest::keyClick(&editor, Qt::Key_Escape);
  EXPECT_FALSE(editor.isVisible());
  EXPECT_EQ(look(), CurveLook{});
}

TEST_F(CurveEditorTest, OneButtonResetsTheLook) {
  view_.setLook(kJoint, {.scaling = {.factor = 5}, .axis = "mine"});
  CurveEditor& editor = Open();
  EXPECT_EQ(editor.findChild<QLineEdit*>("curveEditor.factor")->text(), "5");
  EXPECT_EQ(editor.findChild<QComboBox*>("curveEditor.axis")->currentText(), "mine");

  editor.findChild<QPushButton*>("curveEditor.plain")->click();

  EXPECT_EQ(look(), CurveLook{});
}

TEST_F(CurveEditorTest, TheMenuOfTheRowOpensTheEditor) {
  QContextMenuEvent asked(QContextMenuEvent::Keyboard, {4, 4}, row().mapToGlobal(QPoint(4, 4)));
  QApplication::sendEvent(&row(), &asked);
  auto* menu = row().findChild<QMenu*>("legendMenu");
  ASSERT_NE(menu, nullptr);
  ASSERT_EQ(menu->actions().size(), 4);
  EXPECT_EQ(menu->actions()[1]->text(), "Hide");

  menu->actions()[0]->trigger();

  EXPECT_NE(view_.findChild<CurveEditor*>(), nullptr);
}

TEST_F(CurveEditorTest, RendersTheEditor) {
  for (const auto choice : {Theme::Choice::kLight, Theme::Choice::kDark}) {
    const QString name = choice == Theme::Choice::kLight ? "light" : "dark";
    Theme::instance().choose(choice);
    view_.setLook(kJoint, {.scaling = {.factor = 1000, .offset = 2}});
    QImage image = Painted(view_);
    CurveEditor& editor = Open();
    Type(editor, "curveEditor.offset", "much");
    QPainter(&image).drawPixmap(12, 40, editor.grab());
    KeepPicture(image, "plot-scaled-" + name);
    editor.close();
  }
}

}  // namespace
}  // namespace tendon::gui
