#include <gcm_gui/replay/time_slider.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyleOptionFocusRect>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tendon::gui {
namespace {

constexpr int kSide = 8;     // pixels on both sides of the line, so that the handle has room
constexpr int kGroove = 4;   // height
constexpr int kHandle = 12;  // diameter
constexpr int kEventHeight = 6;
constexpr std::int64_t kMaxValues = 1'000'000'000;
constexpr double kPage = 0.1;  // of the length

}  // namespace

QString MomentText(std::int64_t since_begin_ns) {
  const std::int64_t all_ms = std::max<std::int64_t>(0, since_begin_ns) / 1'000'000;
  const auto two = [](std::int64_t number) {
    return QStringLiteral("%1").arg(number, 2, 10, QLatin1Char('0'));
  };
  const std::int64_t hours = all_ms / 3'600'000;
  const std::int64_t minutes = all_ms / 60'000 % 60;
  const QString rest = two(all_ms / 1000 % 60) + QLatin1Char('.') +
                       QStringLiteral("%1").arg(all_ms % 1000, 3, 10, QLatin1Char('0'));
  if (hours == 0) return QString::number(minutes) + ':' + rest;
  return QString::number(hours) + ':' + two(minutes) + ':' + rest;
}

TimeSlider::TimeSlider(QWidget* parent) : QAbstractSlider(parent) {
  setObjectName(QStringLiteral("replayTime"));
  setAccessibleName(Words::tr("Moment of the recording"));
  setOrientation(Qt::Horizontal);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  // A screen reader can also set the value.
  connect(this, &QAbstractSlider::actionTriggered, this, [this](int action) {
    if (action == SliderMove) Q_EMIT sought(first_ + sliderPosition() * unit_);
  });
  connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void TimeSlider::setRange(std::int64_t first, std::int64_t last) {
  first_ = first;
  last_ = std::max(first, last);
  unit_ = std::max<std::int64_t>(1'000'000, (last_ - first_) / kMaxValues + 1);
  QAbstractSlider::setRange(0, static_cast<int>((last_ - first_) / unit_));
  findColumns();
}

void TimeSlider::setEvents(std::vector<Span> spans) {
  events_ = std::move(spans);
  findColumns();
}

void TimeSlider::setLosses(std::vector<Span> spans) {
  losses_ = std::move(spans);
  findColumns();
}

void TimeSlider::setMarks(std::vector<Span> spans) {
  marks_ = std::move(spans);
  update();
}

void TimeSlider::setTime(std::int64_t time) {
  time_ = std::clamp(time, first_, last_);
  setValue(static_cast<int>((time_ - first_) / unit_));
  update();
}

std::int64_t TimeSlider::timeAt(double x) const {
  const double width = std::max(1, this->width() - 2 * kSide);
  const double part = std::clamp((x - kSide) / width, 0.0, 1.0);
  return first_ + std::llround(part * static_cast<double>(last_ - first_));
}

double TimeSlider::xOf(std::int64_t time) const {
  if (last_ == first_) return kSide;
  const double part = static_cast<double>(time - first_) / static_cast<double>(last_ - first_);
  return kSide + part * (width() - 2 * kSide);
}

std::vector<bool> TimeSlider::columnsOf(const std::vector<Span>& spans) const {
  std::vector<bool> columns(static_cast<std::size_t>(std::max(0, width())));
  for (const Span& span : spans) {
    const double most = width() - 1;
    const auto from = static_cast<std::size_t>(std::clamp(std::floor(xOf(span.from)), 0.0, most));
    const auto to = static_cast<std::size_t>(std::clamp(std::floor(xOf(span.to)), 0.0, most));
    for (std::size_t x = from; x <= to && x < columns.size(); ++x) columns[x] = true;
  }
  return columns;
}

void TimeSlider::findColumns() {
  event_columns_ = columnsOf(events_);
  loss_columns_ = columnsOf(losses_);
  update();
}

void TimeSlider::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = Theme::instance();
  const double middle = height() / 2.0;
  const double present = xOf(time_);
  const QRectF groove(kSide, middle - kGroove / 2.0, width() - 2 * kSide, kGroove);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.color(Token::kLine));
  painter.drawRoundedRect(groove, 2, 2);
  painter.setBrush(theme.color(Token::kAccent));
  painter.drawRoundedRect(QRectF(groove.topLeft(), QPointF(present, groove.bottom())), 2, 2);
  painter.setRenderHint(QPainter::Antialiasing, false);
  const auto draw = [&](const std::vector<bool>& columns, Token token, int top, int bottom) {
    for (std::size_t x = 0; x < columns.size(); ++x) {
      if (columns[x])
        painter.fillRect(static_cast<int>(x), top, 2, bottom - top, theme.color(token));
    }
  };
  const int line = static_cast<int>(middle);
  draw(event_columns_, Token::kDim, line + kGroove, line + kGroove + kEventHeight);
  draw(loss_columns_, Token::kBad, line - kGroove / 2 - kEventHeight, line + kGroove / 2);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(theme.color(Token::kWarning));
  for (const Span& mark : marks_) {
    const double x = xOf(mark.from);
    painter.drawPolygon(QPolygonF({{x - 4.0, 2.0}, {x + 4.0, 2.0}, {x, 9.0}}));
  }
  if (hover_) {
    painter.setPen(theme.color(Token::kDim));
    painter.drawLine(QPointF(*hover_, 4), QPointF(*hover_, height() - 4));
    painter.setPen(Qt::NoPen);
  }
  painter.setBrush(theme.color(Token::kText));
  painter.drawEllipse(QPointF(present, middle), kHandle / 2.0, kHandle / 2.0);
  if (!hasFocus()) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.color(Token::kAccent), 2));
  painter.drawEllipse(QPointF(present, middle), kHandle / 2.0 + 2, kHandle / 2.0 + 2);
}

void TimeSlider::resizeEvent(QResizeEvent* event) {
  QAbstractSlider::resizeEvent(event);
  findColumns();
}

void TimeSlider::seekTo(std::int64_t time) {
  setTime(time);
  Q_EMIT sought(time_);
}

void TimeSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  setSliderDown(true);
  seekTo(timeAt(event->position().x()));
}

void TimeSlider::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x();
  hover_ = std::clamp<double>(x, kSide, width() - kSide);
  QToolTip::showText(event->globalPosition().toPoint(), MomentText(timeAt(x) - first_), this);
  if (isSliderDown()) seekTo(timeAt(x));
  update();
}

void TimeSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) setSliderDown(false);
}

void TimeSlider::leaveEvent(QEvent* event) {
  hover_.reset();
  update();
  QAbstractSlider::leaveEvent(event);
}

void TimeSlider::keyPressEvent(QKeyEvent* event) {
  const auto page = static_cast<std::int64_t>(static_cast<double>(last_ - first_) * kPage);
  switch (event->key()) {
    case Qt::Key_Left:
      return Q_EMIT stepRequested(-1);
    case Qt::Key_Right:
      return Q_EMIT stepRequested(1);
    case Qt::Key_PageUp:
      return seekTo(time_ + page);
    case Qt::Key_PageDown:
      return seekTo(time_ - page);
    case Qt::Key_Home:
      return seekTo(first_);
    case Qt::Key_End:
      return seekTo(last_);
    default:
      event->ignore();
  }
}

void TimeSlider::wheelEvent(QWheelEvent* event) {
  Q_EMIT stepRequested(event->angleDelta().y() > 0 ? -1 : 1);
  event->accept();
}

}  // namespace tendon::gui
