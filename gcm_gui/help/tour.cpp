#include <gcm_gui/help/tour.h>

#include <gcm_gui/help/tour_card.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QApplication>
#include <QEvent>
#include <QLayout>
#include <QPainter>
#include <QPainterPath>
#include <utility>

namespace tendon::gui {
namespace {

constexpr double kDimmed = 0.66;  // opacity of the canvas colour in the dimmed area
constexpr int kRim = 2;

bool CanBeSeen(const QWidget* target, const QWidget& window) {
  return target != nullptr && window.isAncestorOf(target) && target->isVisible() &&
         !target->size().isEmpty();
}

}  // namespace

Tour::Tour(std::vector<TourStep> steps, QWidget& window)
    : QWidget(&window), all_(std::move(steps)), window_(window), card_(new TourCard(this)) {
  setObjectName(QStringLiteral("tour"));
  setAccessibleName(Words::tr("Tour"));
  setAttribute(Qt::WA_NoMousePropagation);
  connect(card_, &TourCard::nextRequested, this, &Tour::next);
  connect(card_, &TourCard::backRequested, this, &Tour::back);
  connect(card_, &TourCard::endRequested, this, &Tour::end);
  connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
  connect(qApp, &QApplication::focusChanged, this,
          [this](const QWidget*, const QWidget* now) { onFocusChanged(now); });
  hide();
}

void Tour::start() {
  if (!isRunning()) before_ = window_.focusWidget();
  steps_ = all_;
  QWidget* first = nullptr;
  while (first == nullptr && !steps_.empty()) first = reach(0);
  if (first == nullptr) return end();
  QWidget::show();
  raise();
  showStep(0, *first);
  card_->takeFocus();
}

void Tour::end() {
  if (!isRunning()) return;
  const bool had_focus = isAncestorOf(window_.focusWidget());
  follow(nullptr);
  hide();
  if (had_focus && before_ != nullptr) before_->setFocus(Qt::OtherFocusReason);
}

void Tour::next() {
  while (step_ + 1 < steps_.size()) {
    if (QWidget* target = reach(step_ + 1)) return showStep(step_ + 1, *target);
  }
  end();
}

void Tour::back() {
  while (step_ > 0) {
    if (QWidget* target = reach(--step_)) return showStep(step_, *target);
  }
  if (target_ != nullptr) showStep(step_, *target_);  // all earlier steps were skipped
}

QWidget* Tour::reach(std::size_t step) {
  QWidget* target = steps_[step].target();
  if (window_.layout() != nullptr) window_.layout()->activate();
  if (CanBeSeen(target, window_)) return target;
  steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(step));
  return nullptr;
}

void Tour::showStep(std::size_t step, QWidget& target) {
  step_ = step;
  follow(&target);
  const TourStep& shown = steps_[step];
  card_->show(shown.title, shown.text, static_cast<int>(step) + 1, static_cast<int>(steps_.size()));
  place();
}

void Tour::follow(QWidget* target) {
  for (const auto& widget : std::as_const(followed_)) {
    if (widget != nullptr) widget->removeEventFilter(this);
  }
  followed_.clear();
  target_ = target;
  for (QWidget* widget = target; widget != nullptr; widget = widget->parentWidget()) {
    widget->installEventFilter(this);
    followed_.append(widget);
  }
}

void Tour::place() {
  setGeometry(window_.rect());
  hole_ = {};
  if (CanBeSeen(target_, window_)) {
    hole_ = QRect(target_->mapTo(&window_, QPoint()), target_->size()).adjusted(-2, -2, 2, 2) &
            rect().adjusted(kRim, kRim, -kRim, -kRim);
  }
  const QRect room = rect().adjusted(kInset, kInset, -kInset, -kInset);
  card_->setGeometry(CardBeside(hole_.isEmpty() ? rect() : hole_,
                                card_->wantedSize().boundedTo(room.size()), room));
  update();
}

void Tour::onFocusChanged(const QWidget* now) {
  if (!isRunning() || now == nullptr || now->window() != &window_) return;
  if (now != this && !isAncestorOf(now)) end();
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Resize:
    case QEvent::Move:
    case QEvent::Show:
    case QEvent::Hide:
      place();
      break;
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

void Tour::paintEvent(QPaintEvent*) {
  const Theme& theme = Theme::instance();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath dimmed;
  dimmed.addRect(rect());
  QPainterPath hole;
  hole.addRoundedRect(hole_, kRadius, kRadius);
  painter.fillPath(dimmed.subtracted(hole), theme.color(Token::kCanvas, kDimmed));
  painter.setPen(QPen(theme.color(Token::kAccent), kRim));
  painter.drawPath(hole);
}

}  // namespace tendon::gui
