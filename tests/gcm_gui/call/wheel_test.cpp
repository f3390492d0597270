#include <gcm_gui/theme/theme.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

namespace tendon::gui {
namespace {

/// A form that scrolls, with a choice, an editable choice, and a number.
class WheelTest : public ::testing::Test {
 protected:
  WheelTest() {
    Theme::instance();
    auto* form = new QWidget;
    auto* column = new QVBoxLayout(form);
    choice_ = new QComboBox;
    choice_->addItems({"a", "b", "c"});
    choice_->setCurrentIndex(1);
    typed_ = new QComboBox;
    typed_->setEditable(true);
    typed_->addItems({"a", "b", "c"});
    typed_->setCurrentIndex(1);
    number_ = new QDoubleSpinBox;
    number_->setValue(5);
    button_ = new QPushButton("other");
    for (QWidget* const widget :
         std::initializer_list<QWidget*>{choice_, typed_, number_, button_}) {
      column->addWidget(widget);
    }
    form->setMinimumHeight(2000);
    area_.setWidget(form);
    area_.setWidgetResizable(true);
    area_.resize(300, 200);
    area_.show();
    area_.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&area_, 120'000));
    button_->setFocus();
  }

  /// Turns the mouse wheel down over the widget.
  static void Turn(QWidget& widget) {
    QWidget* const child = widget.childAt(widget.rect().center());
    QWidget& under = child == nullptr ? widget : *child;
    const QPointF place = under.rect().center();
    QWheelEvent event(place, under.mapToGlobal(place), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event);  // Qt passes only spontaneous events on to parents
    QApplication::instance()->notify(&under, &event);
  }
  QString Values() { return choice_->currentText() + typed_->currentText() + number_->text(); }
  int Scrolled() { return area_.verticalScrollBar()->value(); }

  QScrollArea area_;
  QComboBox* choice_;
  QComboBox* typed_;
  QDoubleSpinBox* number_;
  QPushButton* button_;
};

TEST_F(WheelTest, ScrollsTheFormOverAnUnfocusedField) {
  const QString before = Values();
  for (QWidget* const field : std::initializer_list<QWidget*>{choice_, typed_, number_}) {
    const int scrolled = Scrolled();
    Turn(*field);
    EXPECT_EQ(Values(), before) << field->metaObject()->className();
    EXPECT_GT(Scrolled(), scrolled) << field->metaObject()->className();
    EXPECT_TRUE(button_->hasFocus()) << "nor does it take the focus";
  }
}

TEST_F(WheelTest, ChangesAFocusedField) {
  number_->setFocus();
  Turn(*number_);
  EXPECT_EQ(number_->value(), 4);
  choice_->setFocus();
  Turn(*choice_);
  EXPECT_EQ(choice_->currentText(), "c");
}

}  // namespace
}  // namespace tendon::gui
