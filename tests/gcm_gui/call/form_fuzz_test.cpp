#include <gcm_gui/call/number_field.h>
#include <gcm_gui/call/value_form.h>
#include <gtest/gtest.h>
#include <tendon/payload/json.h>
#include <tests/support/locales.h>
#include <tests/support/written_number.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QLocale>
#include <QTest>
#include <clocale>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace tendon::gui {
namespace {

using Json = nlohmann::ordered_json;

Schema FuzzSchema() {
  return *Schema::Parse(R"(struct arm.Goal {
  position: float64[4] in rad
  count: int32
  after: duration
}
)");
}

int Rounds() { return std::getenv("TENDON_FULL_FAULTS") == nullptr ? 300 : 20000; }

/// Types and pastes random texts like a user, in each locale.
class FormFuzzTest : public ::testing::TestWithParam<std::string> {
 protected:
  FormFuzzTest() {
    form_.resize(400, 300);
    form_.show();
    fields_ = form_.findChildren<NumberField*>();
  }
  ~FormFuzzTest() override { QLocale::setDefault(QLocale::c()); }

  QStringList Texts() {
    QStringList texts;
    for (const NumberField* field : fields_) texts << field->text();
    return texts;
  }
  /// Expects that the value of every field is exactly the number in its text, to the last digit of
  /// the type. Otherwise the form must be invalid, and the field must show the reason.
  void ExpectWhatIsWritten() {
    const Json value = Json::parse(form_.json());
    const std::vector<Json> numbers{value["position"][0], value["position"][1],
                                    value["position"][2], value["position"][3],
                                    value["count"],       value["after"]};
    for (qsizetype i = 0; i < fields_.size(); ++i) {
      const std::string text = fields_[i]->text().trimmed().toStdString();
      const Json& number = numbers[static_cast<std::size_t>(i)];
      if (!fields_[i]->refusal().isEmpty()) {
        ASSERT_TRUE(number.is_string()) << text;
        ASSERT_FALSE(FromJson(schema_, form_.json())) << text;
        continue;
      }
      if (number.is_string()) {
        ASSERT_TRUE(text.ends_with(number.get<std::string>())) << text;  // inf or nan
        continue;
      }
      ASSERT_TRUE(test::WrittenNumberOf(text)) << text;
      // Reads the text in the C locale, whatever the program's locale is.
      const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
      const double meant = strtod_l(text.c_str(), nullptr, plain);
      freelocale(plain);
      ASSERT_EQ(number.get<double>(), meant) << text;
      if (number.is_number_integer()) {
        ASSERT_EQ(test::WrittenNumberOf(number.dump()), test::WrittenNumberOf(text)) << text;
      }
    }
  }

  test::Locales locales_;
  const Schema schema_ = FuzzSchema();
  ValueForm form_{schema_};
  QList<NumberField*> fields_;
};

TEST_P(FormFuzzTest, AcceptsTheExactNumberOrRejectsIt) {
  ASSERT_TRUE(locales_.Use(GetParam())) << "localedef did not make " << GetParam();
  QLocale::setDefault(QLocale(QString::fromStdString(GetParam())));
  test::RandomWords words(20);
  int callable = 0;
  for (int i = 0; i < Rounds(); ++i) {
    NumberField& field = *fields_[static_cast<qsizetype>(words.Below(6))];
    const QStringList before = Texts();
    const QString word = QString::fromStdString(words.Next());
    const bool is_typed = words.Below(2) == 0;
    field.setFocus();
    field.selectAll();
    if (is_typed) {
      for (const QChar letter : word) {
        QTest::sendKeyEvent(QTest::Click, &field, Qt::Key_unknown, QString(letter), Qt::NoModifier);
      }
      if (words.Below(4) == 0) QTest::keyClick(&field, Qt::Key_Backspace);
    } else {
      QGuiApplication::clipboard()->setText(word);
      QTest::keySequence(&field, QKeySequence::Paste);
    }

    ExpectWhatIsWritten();
    if (HasFatalFailure()) return;
    if (FromJson(schema_, form_.json())) ++callable;
    const QStringList after = Texts();
    if (!field.pasteRefusal().isEmpty()) {
      ASSERT_EQ(after, before) << qPrintable(word);
    }
    for (qsizetype other = 0; other < after.size(); ++other) {
      const bool may_change = fields_[other] == &field || (!is_typed && other < 4);
      if (!may_change) {
        ASSERT_EQ(after[other], before[other]) << qPrintable(word);
      }
      // A list puts each of its words into one field.
      const bool is_other = fields_[other] != &field && after[other] != before[other];
      if (is_other) {
        ASSERT_TRUE(test::WrittenNumberOf(after[other].toStdString()) ||
                    after[other].contains("inf") || after[other].contains("nan"))
            << qPrintable(word);
      }
    }
    if (words.Below(3) == 0) form_.setJson(R"({"position":[0,1,2,3],"count":4,"after":5})");
  }
  EXPECT_GT(callable, 0);
}

INSTANTIATE_TEST_SUITE_P(Locale, FormFuzzTest, ::testing::ValuesIn(test::Locales::Names()),
                         [](const auto& locale) { return locale.param; });

}  // namespace
}  // namespace tendon::gui
