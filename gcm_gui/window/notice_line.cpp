#include <gcm_gui/window/notice_line.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/lifecycle/lifecycle_words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QFontMetrics>
#include <QPainter>
#include <chrono>

namespace tendon::gui {
namespace {

constexpr std::chrono::seconds kShown{8};

int WidthOf(const QString& text, const QFont& font) {
  return QFontMetrics(font).horizontalAdvance(text);
}

/// Returns what the user can do while a connection is made.
QString AdviceOf(const ConnectMode& mode) {
  const bool is_other_provided = mode.chosen().side == Side::kRequired;
  if (mode.former() && mode.best() == nullptr) {
    return is_other_provided
               ? Words::tr(" · no other provided interface fits · D disconnects · Esc cancels")
               : Words::tr(" · no other required interface fits · D disconnects · Esc cancels");
  }
  if (mode.former()) {
    return is_other_provided
               ? Words::tr(" · pick another provided interface · D disconnects · Esc cancels")
               : Words::tr(" · pick another required interface · D disconnects · Esc cancels");
  }
  if (mode.best() == nullptr) {
    return is_other_provided ? Words::tr(" · no provided interface fits · Esc cancels")
                             : Words::tr(" · no required interface fits · Esc cancels");
  }
  return is_other_provided ? Words::tr(" · pick a provided interface · Esc cancels")
                           : Words::tr(" · pick a required interface · Esc cancels");
}

}  // namespace

NoticeLine::NoticeLine(const ConnectMode& mode, const ActivityModel& activity, QWidget* parent)
    : QWidget(parent), mode_(mode) {
  setObjectName(QStringLiteral("notice"));
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  fade_.setSingleShot(true);
  fade_.setInterval(kShown);
  connect(&fade_, &QTimer::timeout, this, [this] { showNotice({}); });
  connect(&mode, &ConnectMode::changed, this, &NoticeLine::refresh);
  connect(&mode, &ConnectMode::notice, this, &NoticeLine::showNotice);
  connect(&activity, &ActivityModel::finished, this, Guarded(this, &NoticeLine::onActionFinished));
  connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void NoticeLine::showNotice(const QString& text) {
  notice_ = text;
  if (!text.isEmpty()) fade_.start();
  refresh();
}

void NoticeLine::onActionFinished(const Action& finished) {
  if (finished.verb == Action::Verb::kRecord || finished.verb == Action::Verb::kSaveLast)
    return;  // the recording has its own line
  if (finished.outcome == Action::Outcome::kRefused) return showNotice(finished.refusal);
  const QString time = DurationText(finished.seconds);
  switch (finished.verb) {
    case Action::Verb::kConnect:
      return showNotice(Words::tr("Connected in %1 · Ctrl+Z undoes").arg(time));
    case Action::Verb::kDisconnect:
      return showNotice(Words::tr("Disconnected in %1 · Ctrl+Z undoes").arg(time));
    case Action::Verb::kReplace:
      return showNotice(Words::tr("Replaced in %1 · Ctrl+Z undoes").arg(time));
    case Action::Verb::kUndo:
      return showNotice(Words::tr("Undone in %1").arg(time));
    case Action::Verb::kForget:
      return showNotice(Words::tr("Forgotten"));
    case Action::Verb::kLifecycle:
      return showNotice(
          finished.lifecycle_verb == LifecycleVerb::kRestart
              ? Words::tr("%1 has been restarted in %2").arg(ToQString(finished.component), time)
              : Words::tr("%1: %2 done in %3 · Ctrl+Z twice undoes")
                    .arg(ToQString(finished.component), WordOf(finished.lifecycle_verb), time));
    case Action::Verb::kCall:
      return showNotice(Words::tr("Called in %1").arg(time));
    case Action::Verb::kLogLevel:
      return showNotice(
          Words::tr("%1 logs %2 and above").arg(ToQString(finished.process), finished.argument));
    case Action::Verb::kApply:
    case Action::Verb::kRecord:
    case Action::Verb::kSaveLast:
      return;  // the plan has its own page
  }
}

void NoticeLine::showMode() {
  before_ = mode_.former() ? Words::tr("Replace ") : Words::tr("Connect ");
  path_ = ToQString(ToString(mode_.former() ? *mode_.former() : mode_.chosen().name));
  after_ = AdviceOf(mode_);
}

void NoticeLine::refresh() {
  before_ = notice_;
  path_.clear();
  after_.clear();
  if (mode_.active()) showMode();
  setToolTip(text());
  setAccessibleName(text());
  updateGeometry();
  update();
}

QSize NoticeLine::sizeHint() const {
  const Theme& theme = Theme::instance();
  return {WidthOf(before_, theme.text()) + WidthOf(path_, theme.mono()) +
              WidthOf(after_, theme.text()) + 2,
          kRowHeight};
}

QSize NoticeLine::minimumSizeHint() const { return {0, kRowHeight}; }

void NoticeLine::paintEvent(QPaintEvent*) {
  const Theme& theme = Theme::instance();
  QPainter painter(this);
  QRect room = rect();
  const auto put = [&](const QString& text, const QFont& font, Token token) {
    painter.setFont(font);
    painter.setPen(theme.color(token));
    const QString shown = QFontMetrics(font).elidedText(text, Qt::ElideRight, room.width());
    painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft, shown);
    room.setLeft(room.left() + WidthOf(shown, font));
  };
  put(before_, theme.text(), Token::kDim);
  put(path_, theme.mono(), Token::kAccent);
  put(after_, theme.text(), Token::kDim);
}

}  // namespace tendon::gui
