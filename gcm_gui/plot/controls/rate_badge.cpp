#include <gcm_gui/plot/controls/rate_badge.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/theme.h>

#include <QStringList>
#include <QStyleOptionToolButton>
#include <QStylePainter>
#include <QToolTip>
#include <algorithm>
#include <limits>

namespace tendon::gui {
namespace {

constexpr int kMinWidth = 70;  // pixels; room for "… 12 lost"

QString Number(double hz) {
  if (hz >= 99.95) return QString::number(hz, 'f', 0);
  // The rate is measured over one second, so further digits would not be exact.
  return QString::number(hz, 'g', hz >= 9.995 ? 3 : 2);
}

std::uint64_t Lost(const std::vector<SourceFigures>& figures) {
  std::uint64_t lost = 0;
  for (const SourceFigures& each : figures) lost += each.lost;
  return lost;
}

}  // namespace

QString RateText(double hz) { return Number(hz) + " Hz"; }

QString BadgeText(const std::vector<SourceFigures>& figures) {
  if (figures.empty()) return {};
  double slowest = std::numeric_limits<double>::infinity();
  double fastest = 0;
  std::uint64_t repeated = 0;
  int silent = 0;
  for (const SourceFigures& each : figures) {
    if (each.rate > 0) slowest = std::min(slowest, each.rate);
    fastest = std::max(fastest, each.rate);
    repeated += each.repeated;
    silent += each.rate > 0 ? 0 : 1;
  }
  const QString rate = RateText(fastest);
  const bool alike = fastest == 0 || RateText(slowest) == rate;
  QString text = alike ? rate : Number(slowest) + QStringLiteral("–") + rate;
  text += Words::tr(" · %1 lost").arg(Lost(figures));
  if (repeated > 0) text += Words::tr(" · %1 repeated").arg(repeated);
  if (silent > 0 && fastest > 0) text += Words::tr(" · %1 silent").arg(silent);
  return text;
}

/// Returns the known losses by place; empty if nothing was lost.
QString PlacesText(const RowLosses& losses) {
  const QString places = LossPlaces(losses, Words::tr("%1 in this window"));
  return places.isEmpty() ? QString() : Words::tr("; lost ") + places;
}

RateBadge::RateBadge(QWidget* parent) : QToolButton(parent) {
  setObjectName("rateBadge");
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  SetRole(*this, "mono dim");
  connect(this, &QToolButton::clicked, this,
          [this] { QToolTip::showText(mapToGlobal(rect().bottomLeft()), toolTip(), this); });
}

void RateBadge::setFigures(const std::vector<SourceFigures>& figures) {
  setVisible(!figures.empty());
  const QString badge = BadgeText(figures);
  if (badge != text()) {
    setText(badge);
    setAccessibleName(Words::tr("Rate and lost rows: ") + badge);
  }
  SetRole(*this, Lost(figures) > 0 ? "mono bad" : "mono dim");
  QStringList lines;
  for (const SourceFigures& each : figures) {
    lines << (each.lost == 1 ? Words::tr("%1: %2, %3 row lost, %4 repeated")
                             : Words::tr("%1: %2, %3 rows lost, %4 repeated"))
                     .arg(each.source, RateText(each.rate))
                     .arg(each.lost)
                     .arg(each.repeated) +
                 (each.lost > 0 ? PlacesText(each.losses) : QString());
  }
  setToolTip(lines.join('\n'));
}

QSize RateBadge::minimumSizeHint() const {
  return sizeHint().boundedTo({kMinWidth, QWIDGETSIZE_MAX});
}

void RateBadge::paintEvent(QPaintEvent*) {
  QStylePainter painter(this);
  QStyleOptionToolButton option;
  initStyleOption(&option);
  const int missing = sizeHint().width() - width();
  if (missing > 0) {
    const int room = fontMetrics().horizontalAdvance(text()) - missing;
    option.text = fontMetrics().elidedText(text(), Qt::ElideLeft, room);
  }
  painter.drawComplexControl(QStyle::CC_ToolButton, option);
}

}  // namespace tendon::gui
