#include <gcm_gui/call/number_box.h>
#include <gtest/gtest.h>

#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QTest>
#include <QVBoxLayout>

namespace tendon::gui {
namespace {

/// Boxes for a rate and a number of calls, and a button that can take the focus.
class NumberBoxTest : public ::testing::Test {
 protected:
  NumberBoxTest() {
    rate_.setRange(0.1, 50);
    rate_.setSuffix(" Hz");
    rate_.setValue(1);
    times_.setRange(0, 100000);
    times_.setSpecialValueText("until stopped");
    auto* column = new QVBoxLayout(&window_);
    for (QWidget* const widget : std::initializer_list<QWidget*>{&rate_, &times_, &button_}) {
      column->addWidget(widget);
    }
    window_.show();
    window_.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window_, 120'000));
  }
  ~NumberBoxTest() override { QLocale::setDefault(QLocale::c()); }
  static void Type(NumberBox& box, const QString& text) {
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, text);
  }

  QWidget window_;
  NumberBox rate_{NumberBox::Numbers::kAll};
  NumberBox times_{NumberBox::Numbers::kWhole};
  QPushButton button_;
};

TEST_F(NumberBoxTest, ReadsNumbersAlikeInAllLocales) {
  for (const char* locale : {"C", "en_US", "de_DE", "fr_FR"}) {
    QLocale::setDefault(QLocale(locale));
    NumberBox box(NumberBox::Numbers::kAll);
    box.setRange(0.1, 5000);
    EXPECT_EQ(box.text(), "0.1") << locale;
    box.setValue(1000);
    EXPECT_EQ(box.text(), "1000") << locale;
  }
  Type(rate_, "0.25");
  EXPECT_EQ(rate_.refusal(), "");
  EXPECT_EQ(rate_.value(), 0.25);
}

TEST_F(NumberBoxTest, KeepsInvalidInputAndExplainsIt) {
  Type(rate_, "0,5");
  EXPECT_TRUE(rate_.text().startsWith("0,5"));
  EXPECT_EQ(rate_.refusal(), "write 0.5: use a point as the decimal sign");
  Type(rate_, "500");
  EXPECT_EQ(rate_.refusal(), "write a number from 0.1 to 50");
  Type(times_, "1.5");
  EXPECT_EQ(times_.refusal(), "write a whole number");
  Type(times_, "1.000,5");
  EXPECT_EQ(times_.refusal(), "write 1000.5: use a point as the decimal sign");
  Type(times_, "12");
  EXPECT_EQ(times_.value(), 12);
}

TEST_F(NumberBoxTest, DoesNotRevertInvalidInput) {
  Type(rate_, "0,5");
  QTest::keyClick(&rate_, Qt::Key_Return);
  button_.setFocus();
  QTest::mouseClick(&button_, Qt::LeftButton);

  EXPECT_TRUE(rate_.text().startsWith("0,5"));
  EXPECT_NE(rate_.refusal(), "");
}

TEST_F(NumberBoxTest, AcceptsASpecialValue) {
  EXPECT_EQ(times_.text(), "until stopped");
  EXPECT_EQ(times_.refusal(), "");
}

}  // namespace
}  // namespace tendon::gui
