#include <gcm_gui/call/number_field.h>
#include <gcm_gui/call/value_form.h>
#include <gtest/gtest.h>
#include <tendon/payload/json.h>

#include <QAction>
#include <QClipboard>
#include <QDropEvent>
#include <QGuiApplication>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QTest>

namespace tendon::gui {
namespace {

Schema FieldSchema() {
  return *Schema::Parse(R"(struct arm.Goal {
  position: float64[3] in rad
  @ 0.5 to 2.5
  speed: float64 in rad/s
  count: uint64
}
)");
}

/// The fields of a form on the screen, used with keys, the clipboard and the mouse.
class NumberFieldTest : public ::testing::Test {
 protected:
  NumberFieldTest() {
    form_.resize(400, 300);
    form_.show();
    form_.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&form_, 120'000));
  }

  NumberField& Field(const QString& name) {
    return *form_.findChild<NumberField*>(QStringLiteral("form.") + name);
  }
  NumberField& Joint(qsizetype index) {
    return *form_.findChild<QWidget*>("form.position")->findChildren<NumberField*>().at(index);
  }
  QString Refusals(const QString& name) {
    const auto* label = form_.findChild<QLabel*>(QStringLiteral("refusals.") + name);
    return label->isVisible() ? label->text() : QString();
  }
  void Type(NumberField& field, const QString& text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
  }
  static void Paste(NumberField& field, const QString& text) {
    QGuiApplication::clipboard()->setText(text);
    field.setFocus();
    field.selectAll();
    QTest::keySequence(&field, QKeySequence::Paste);
  }
  bool IsCallable() { return FromJson(schema_, form_.json()).ok(); }

  const Schema schema_ = FieldSchema();
  ValueForm form_{schema_};
};

TEST_F(NumberFieldTest, RejectsAPastedDecimalComma) {
  for (const QString comma : {"0,123", "0,1234"}) {
    Paste(Joint(0), comma);

    EXPECT_EQ(Joint(0).text(), comma);
    EXPECT_EQ(Joint(1).text(), "0");
    EXPECT_FALSE(IsCallable());
    EXPECT_EQ(Refusals("position"), "[0]: write " + QString(comma).replace(',', '.') +
                                        ": use a point as the decimal sign");
  }
  Paste(Joint(0), "1.234,5");
  EXPECT_EQ(Refusals("position"), "[0]: write 1234.5: use a point as the decimal sign");
}

TEST_F(NumberFieldTest, KeepsATypedDecimalCommaWhileEditing) {
  Type(Joint(1), "0,1234");
  QTest::keyClick(&Joint(1), Qt::Key_Backspace);

  EXPECT_EQ(form_.json(), R"({"position":[0,"0,123",0],"speed":0.5,"count":0})");
  EXPECT_EQ(Joint(2).text(), "0");
  EXPECT_FALSE(IsCallable());
}

TEST_F(NumberFieldTest, EachInvalidFieldShowsItsError) {
  Type(Joint(0), "0,5");
  Type(Joint(2), "5deg");
  Type(Field("speed"), "9");
  Type(Field("count"), "1.5");

  EXPECT_EQ(Refusals("position"),
            "[0]: write 0.5: use a point as the decimal sign\n[2]: write the number alone, in rad");
  EXPECT_EQ(Refusals("speed"), "write a number from 0.5 to 2.5 rad/s");
  EXPECT_EQ(Refusals("count"), "write a whole number");
  EXPECT_EQ(form_.wrongFields(), (QStringList{"position", "speed", "count"}));
  EXPECT_EQ(Joint(0).accessibleDescription(), "write 0.5: use a point as the decimal sign");
  Type(Joint(0), "0.5");
  EXPECT_EQ(Refusals("position"), "[2]: write the number alone, in rad");
}

TEST_F(NumberFieldTest, APastedListFillsTheFollowingFields) {
  Paste(Joint(1), "[0.25,\t-1e-3]");
  EXPECT_EQ(form_.json(), R"({"position":[0,0.25,-0.001],"speed":0.5,"count":0})");
  Paste(Joint(0), "1;2;3");
  EXPECT_EQ(form_.json(), R"({"position":[1,2,3],"speed":0.5,"count":0})");
}

TEST_F(NumberFieldTest, RejectsAnUnfittingListAsAWhole) {
  const std::string before = form_.json();
  struct Case {
    QString text;
    QString refusal;
  };
  for (const auto& [text, refusal] :
       QList<Case>{{"1 2 3 4", "expected at most 2 numbers from this field on, found 4"},
                   {"0,5 1,5", "“0,5”: write 0.5: use a point as the decimal sign"},
                   {"1 x", "“x”: write a number in digits"},
                   {"1\t\t2", "a number is missing in the list"},
                   {"0.1,0.2,0.3", "put a space after each comma between numbers"}}) {
    Paste(Joint(1), text);
    EXPECT_EQ(form_.json(), before);
    EXPECT_EQ(Refusals("position"), "[1]: Nothing was pasted: " + refusal);
    EXPECT_TRUE(IsCallable());
  }
  Type(Joint(1), "1");
  EXPECT_EQ(Refusals("position"), "");

  Paste(Field("speed"), "1 2");
  EXPECT_EQ(Field("speed").text(), "0.5");
  EXPECT_EQ(Refusals("speed"), "Nothing was pasted: expected one number, found 2");
}

TEST_F(NumberFieldTest, TheContextMenuAndDropPasteLists) {
  QGuiApplication::clipboard()->setText("1 2 3");
  QMenu* menu = Joint(0).createStandardContextMenu();
  for (QAction* action : menu->actions()) {
    if (action->text().contains("Paste")) action->trigger();
  }
  delete menu;
  EXPECT_EQ(form_.json(), R"({"position":[1,2,3],"speed":0.5,"count":0})");

  QMimeData dropped;
  dropped.setText("4 5 6");
  QDragEnterEvent enter({5, 5}, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&Joint(0), &enter);
  QDropEvent drop({5, 5}, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&Joint(0), &drop);
  EXPECT_EQ(form_.json(), R"({"position":[4,5,6],"speed":0.5,"count":0})");
}

TEST_F(NumberFieldTest, UndoRevertsAPasteInItsField) {
  Paste(Joint(0), "7 8 9");
  QTest::keySequence(&Joint(0), QKeySequence::Undo);
  EXPECT_EQ(Joint(0).text(), "0");
  EXPECT_EQ(Joint(1).text(), "8");
}

TEST_F(NumberFieldTest, ShowsTheFrontOfALongNumber) {
  const QString longest = "-0.99999999999999891234";
  form_.setJson(R"({"position":[0.9999999999999989,-4.4e-323,0],"speed":1,"count":7})");
  Field("speed").setFocus();

  EXPECT_EQ(Joint(0).text(), "0.9999999999999989");
  EXPECT_TRUE(Joint(0).shownText().startsWith("0.9")) << qPrintable(Joint(0).shownText());
  EXPECT_TRUE(Joint(0).shownText().endsWith("…"));
  EXPECT_TRUE(Joint(1).shownText().startsWith("-4")) << qPrintable(Joint(1).shownText());
  EXPECT_TRUE(Joint(1).shownText().endsWith("e-323"));
  EXPECT_EQ(Joint(0).cursorPosition(), 0);
  EXPECT_EQ(Joint(0).toolTip(), "0.9999999999999989\n[0]");
  QTest::keyClick(&Field("speed"), Qt::Key_Backtab);
  EXPECT_TRUE(Joint(2).hasFocus());
  Type(Joint(2), longest);
  EXPECT_EQ(Joint(2).text(), longest);
  Field("speed").setFocus();
  EXPECT_EQ(Joint(2).cursorPosition(), 0);
  EXPECT_TRUE(Joint(2).shownText().startsWith("-0.9"));
}

TEST_F(NumberFieldTest, TabbingToAFieldShowsItsFront) {
  form_.setJson(R"({"position":[0,0.9999999999999989,0]})");
  Joint(0).setFocus();

  QTest::keyClick(&Joint(0), Qt::Key_Tab);

  EXPECT_TRUE(Joint(1).hasFocus());
  EXPECT_EQ(Joint(1).selectedText(), Joint(1).text());
  EXPECT_EQ(Joint(1).cursorPosition(), 0);
}

TEST_F(NumberFieldTest, AnUnfocusedFieldDoesNotDrawTheTail) {
  form_.setJson(R"({"position":[0.1111111111111777,0,0]})");
  Field("speed").setFocus();
  const QImage before = Joint(0).grab().toImage();
  form_.setJson(R"({"position":[0.1111111111111999,0,0]})");
  EXPECT_EQ(Joint(0).grab().toImage(), before) << "the tail is not seen";
  form_.setJson(R"({"position":[0.7111111111111999,0,0]})");
  EXPECT_NE(Joint(0).grab().toImage(), before);
}

}  // namespace
}  // namespace tendon::gui
