#include <gcm_gui/call/value_form.h>
#include <gtest/gtest.h>
#include <tendon/payload/json.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QTest>

namespace tendon::gui {
namespace {

/// Returns a schema with fields of every kind, some of them nested.
Schema GoalSchema() {
  auto schema = Schema::Parse(R"(struct arm.Goal {
  # Where to.
  position: float64[5] in rad
  @ 0.5 to 2.5
  speed: float64 in rad/s
  count: uint64
  hold: bool
  mode: enum arm.Mode {
    off = 0
    on = 3
  }
  note: string
  after: duration
  via: float32[]
  frame: struct arm.Frame {
    name: string
    parent: int8
  }
}
)");
  EXPECT_TRUE(schema) << (schema ? "" : schema.error().message);
  return *schema;
}

class ValueFormTest : public ::testing::Test {
 protected:
  template <typename Widget>
  Widget& Find(const QString& field) {
    auto* widget = form_.findChild<Widget*>(QStringLiteral("form.") + field);
    EXPECT_NE(widget, nullptr) << field.toStdString();
    return *widget;
  }
  QList<QLineEdit*> Cells(const QString& field) {
    return Find<QWidget>(field).findChildren<QLineEdit*>();
  }
  /// Sets the focus to the cell, and puts the cursor at the end of its text.
  void Enter(QLineEdit& cell) {
    form_.show();
    form_.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&form_, 120'000));
    cell.setFocus();
    cell.end(false);
  }

  const Schema schema_ = GoalSchema();
  ValueForm form_{schema_};
};

TEST_F(ValueFormTest, StartsWithAValidValue) {
  EXPECT_EQ(form_.json(),
            R"({"position":[0,0,0,0,0],"speed":0.5,"count":0,"hold":false,"mode":"off","note":"",)"
            R"("after":0,"via":[],"frame":{"name":"","parent":0}})");
  EXPECT_TRUE(FromJson(schema_, form_.json()));
}

TEST_F(ValueFormTest, ReturnsTheEnteredValues) {
  int edits = 0;
  QObject::connect(&form_, &ValueForm::edited, &form_, [&] { ++edits; });

  Enter(*Cells("position")[1]);
  QTest::keyClicks(Cells("position")[1], QStringLiteral(".25"));
  Find<QLineEdit>("count").setText(QStringLiteral("18446744073709551615"));
  Find<QCheckBox>("hold").setChecked(true);
  Find<QComboBox>("mode").setCurrentIndex(1);
  Find<QLineEdit>("note").setText(QStringLiteral("12"));
  Find<QLineEdit>("via").setText(QStringLiteral("[1, 2]"));
  Find<QLineEdit>("frame.name").setText(QStringLiteral("tool \"A\""));

  EXPECT_EQ(form_.json(),
            R"({"position":[0,0.25,0,0,0],"speed":0.5,"count":18446744073709551615,"hold":true,)"
            R"("mode":"on","note":"12","after":0,"via":[1,2],)"
            R"("frame":{"name":"tool \"A\"","parent":0}})");
  EXPECT_TRUE(FromJson(schema_, form_.json()));
  EXPECT_GE(edits, 7);
}

TEST_F(ValueFormTest, PassesInvalidNumbersToTheParser) {
  Find<QLineEdit>("speed").setText(QStringLiteral("fast"));

  const auto body = FromJson(schema_, form_.json());

  ASSERT_FALSE(body);
  EXPECT_NE(body.error().message.find("speed: expected a number"), std::string::npos)
      << body.error().message;
}

TEST_F(ValueFormTest, ATypedDecimalCommaDoesNotChangeTheNextCell) {
  QLineEdit* cell = Cells("position")[1];
  Enter(*cell);

  QTest::keyClicks(cell, QStringLiteral(",5"));

  EXPECT_EQ(form_.json().substr(0, 30), R"({"position":[0,"0,5",0,0,0],"s)");
}

TEST_F(ValueFormTest, ShowsAGivenValue) {
  const std::string json =
      R"({"position":[1,2,3,4,5.5],"speed":2.0,"count":7,"hold":true,"mode":"on","note":"a",)"
      R"("after":0.25,"via":[0.5],"frame":{"name":"b","parent":-3}})";

  form_.setJson(json);

  EXPECT_EQ(form_.json(), json);
}

TEST_F(ValueFormTest, UnfittingJsonChangesNothing) {
  const std::string before = form_.json();

  form_.setJson(R"({"position":7,"frame":[],"other":1})");
  form_.setJson("no JSON");

  EXPECT_EQ(form_.json(), before);
}

TEST_F(ValueFormTest, EveryFieldHasAnAccessibleName) {
  for (const QLineEdit* line : form_.findChildren<QLineEdit*>()) {
    EXPECT_FALSE(line->accessibleName().isEmpty()) << line->objectName().toStdString();
  }
  EXPECT_EQ(Cells("position")[4]->accessibleName(), "position[4]");
  EXPECT_EQ(Find<QLineEdit>("frame.parent").accessibleName(), "frame.parent");
}

TEST(ValueFormOfANumber, HasOneField) {
  ValueForm form{Schema(Schema::Kind::kFloat64)};

  form.findChild<QLineEdit*>(QStringLiteral("form.value"))->setText(QStringLiteral("2.5"));

  EXPECT_EQ(form.json(), "2.5");
}

TEST(ValueFormOfDurations, KeepsEveryNanosecond) {
  const Schema schema = *Schema::Parse(R"(struct hall.Times {
  start: duration
  others: duration[2]
}
)");
  const std::string json = R"({"start":1700000000.123456789,"others":[0.5,-1700000000.000000001]})";
  const auto body = FromJson(schema, json);
  ValueForm form{schema};

  form.setJson(json);

  EXPECT_EQ(*FromJson(schema, form.json()), *body) << form.json();
  form.findChild<QLineEdit*>(QStringLiteral("form.start"))->setText("1700000000.987654321");
  EXPECT_EQ(*FromJson(schema, form.json()), *FromJson(schema, R"({"start":1700000000.987654321,
                                  "others":[0.5,-1700000000.000000001]})"));
}

}  // namespace
}  // namespace tendon::gui
