#include <gcm_gui/recording/record_button.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>

namespace tendon::gui {
namespace {

QString ScopeSentence(RecordingScope scope) {
  switch (scope) {
    case RecordingScope::kPlotted:
      return Words::tr("Records the plotted signals into a file  (Ctrl+R)");
    case RecordingScope::kSelected:
      return Words::tr("Records the selected component into a file  (Ctrl+R)");
    case RecordingScope::kEverything:
      break;
  }
  return Words::tr("Records everything into a file  (Ctrl+R)");
}

}  // namespace

RecordButton::RecordButton(RecordingController& controller, QMenu& menu, QWidget* parent)
    : QWidget(parent), controller_(controller), button_(new QPushButton), arrow_(new QPushButton) {
  button_->setObjectName(QStringLiteral("record"));
  button_->setFocusPolicy(Qt::TabFocus);
  SetRole(*button_, QStringLiteral("splitLeft"));
  arrow_->setObjectName(QStringLiteral("recordMenu"));
  arrow_->setAccessibleName(Words::tr("What to record"));
  arrow_->setToolTip(arrow_->accessibleName());
  arrow_->setIcon(ThemeIcon(QStringLiteral("menu_arrow")));
  arrow_->setFocusPolicy(Qt::TabFocus);
  SetRole(*arrow_, QStringLiteral("splitRight"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(button_);
  row->addWidget(arrow_);
  connect(button_, &QPushButton::clicked, &controller_, &RecordingController::toggle);
  connect(arrow_, &QPushButton::clicked, this, [this, &menu] {
    menu.popup(arrow_->mapToGlobal(
        QPoint(arrow_->width() - menu.sizeHint().width(), arrow_->height() + kGap)));
  });
  connect(&controller_, &RecordingController::changed, this, Guarded(this, &RecordButton::refresh));
  refresh();
}

void RecordButton::refresh() {
  const bool is_idle = controller_.state() == RecordingController::State::kIdle;
  const QString text = is_idle ? Words::tr("Record") : Words::tr("Stop");
  button_->setText(is_text_shown_ ? text : QString());
  button_->setIcon(is_idle ? ThemeIcon(QStringLiteral("record"), Token::kBad)
                           : ThemeIcon(QStringLiteral("stop"), Token::kText));
  button_->setAccessibleName(is_idle ? Words::tr("Record") : Words::tr("Stop the recording"));
  button_->setToolTip(is_idle ? ScopeSentence(controller_.scope())
                              : Words::tr("Completes the file  (Ctrl+R)"));
  button_->setEnabled(controller_.state() != RecordingController::State::kStopping);
}

void RecordButton::setTabPlace(QWidget* before, QWidget* after) {
  setTabOrder(before, button_);
  setTabOrder(button_, arrow_);
  setTabOrder(arrow_, after);
}

void RecordButton::setTextShown(bool shown) {
  is_text_shown_ = shown;
  refresh();
}

int RecordButton::textWidth() const {
  return button_->text().isEmpty() ? 0 : button_->fontMetrics().horizontalAdvance(button_->text());
}

}  // namespace tendon::gui
