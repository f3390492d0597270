#include <gcm_gui/call/repeat_row.h>

#include <gcm_gui/call/hold_button.h>
#include <gcm_gui/call/number_box.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>

#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStringList>
#include <cmath>
#include <utility>

namespace tendon::gui {
namespace {

constexpr double kHighestRate = 50;  // Hz; code that must call faster belongs in a component
constexpr int kMaxRepeats = 100000;
constexpr double kCallsUntilItExpires = 2;  // two calls per expiry time, because one may be late

}  // namespace

RepeatRow::RepeatRow(CommandCalls& calls, std::function<std::string()> argument, QWidget* parent)
    : QWidget(parent),
      repeater_(calls),
      argument_(std::move(argument)),
      rate_(new NumberBox(NumberBox::Numbers::kAll)),
      times_(new NumberBox(NumberBox::Numbers::kWhole)),
      button_(new QPushButton) {
  setObjectName(QStringLiteral("call.repeatRow"));
  rate_->setObjectName(QStringLiteral("call.rate"));
  rate_->setAccessibleName(Words::tr("Calls a second"));
  rate_->setRange(0.1, kHighestRate);
  rate_->setValue(1);
  rate_->setSuffix(QStringLiteral(" Hz"));
  times_->setObjectName(QStringLiteral("call.times"));
  times_->setAccessibleName(Words::tr("How many calls"));
  times_->setRange(0, kMaxRepeats);
  times_->setSpecialValueText(Words::tr("until stopped"));
  times_->setSuffix(Words::tr(" times"));
  button_->setObjectName(QStringLiteral("call.repeat"));
  button_->setProperty("changesSystem", true);
  button_->installEventFilter(this);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kInset, 0, kInset, 2 * kGrid);
  row->setSpacing(2 * kGrid);
  row->addWidget(rate_);
  row->addWidget(times_, 1);
  row->addWidget(button_);
  hold_.setSingleShot(true);
  hold_.setInterval(HoldButton::kHold);
  connect(&hold_, &QTimer::timeout, this, Guarded(this, &RepeatRow::begin));
  connect(button_, &QPushButton::pressed, this, [this] {
    if (careful_) hold_.start();
  });
  connect(button_, &QPushButton::released, this, [this] {
    if (careful_) stopRepeating();
  });
  connect(button_, &QPushButton::clicked, this, [this] {
    if (careful_) return;
    repeater_.isRunning() ? repeater_.stop() : begin();
  });
  connect(&repeater_, &Repeater::progressed, this,
          [this] { Q_EMIT statusChanged(counts(), false); });
  connect(&repeater_, &Repeater::stopped, this, [this](const QString& refusal) {
    showButton();
    const QString ended = counts() + (refusal.isEmpty() ? QString() : QStringLiteral("\n"));
    Q_EMIT statusChanged(ended + refusal, !refusal.isEmpty());
  });
  for (NumberBox* const box : {rate_, times_}) {
    connect(box, &NumberBox::edited, this, &RepeatRow::checkNumbers);
  }
  showButton();
}

void RepeatRow::checkNumbers() {
  QStringList refusals{rate_->refusal(), times_->refusal()};
  refusals.removeAll(QString());
  const bool was_refused = std::exchange(is_refused_, !refusals.isEmpty());
  if (is_refused_ || was_refused) Q_EMIT statusChanged(refusals.join('\n'), is_refused_);
  showButton();
}

QString RepeatRow::counts() const {
  QString text = CountText(repeater_.called(), Words::tr("%1 call"), Words::tr("%1 calls"));
  if (repeater_.leftOut() > 0) {
    text += Words::tr(", %1 skipped: the previous call took too long").arg(repeater_.leftOut());
  }
  return text;
}

void RepeatRow::begin() {
  if (is_refused_) return;
  repeater_.start(path_, argument_(), rate_->value(), static_cast<int>(times_->value()));
  showButton();
}

void RepeatRow::showButton() {
  button_->setEnabled(is_callable_ && (!is_refused_ || repeater_.isRunning()));
  const QString start = careful_ ? Words::tr("Hold to repeat") : Words::tr("Repeat");
  button_->setText(repeater_.isRunning() && !careful_ ? Words::tr("Stop") : start);
  button_->setToolTip(careful_ ? Words::tr("This command can move something: hold the button for "
                                           "0.4 s; the calls repeat until you release the button")
                               : QString());
}

void RepeatRow::stopRepeating() {
  hold_.stop();
  repeater_.stop();
}

void RepeatRow::setCommand(const QString& path, double expires_after) {
  stopRepeating();
  path_ = path;
  rate_->setValue(expires_after > 0 ? std::ceil(kCallsUntilItExpires / expires_after) : 1);
}

void RepeatRow::setCareful(bool careful) {
  if (careful != careful_) stopRepeating();
  careful_ = careful;
  showButton();
}

void RepeatRow::setCallable(bool callable) {
  if (!callable) stopRepeating();
  is_callable_ = callable;
  showButton();
}

bool RepeatRow::eventFilter(QObject* watched, QEvent* event) {
  const bool is_left = event->type() == QEvent::FocusOut || event->type() == QEvent::Hide;
  if (careful_ && is_left) stopRepeating();
  return QWidget::eventFilter(watched, event);
}

void RepeatRow::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  stopRepeating();
}

}  // namespace tendon::gui
