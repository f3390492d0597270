#include <gcm_gui/graph/card_placement.h>

#include <cmath>

namespace tendon::gui {
namespace {

constexpr double kDistance = 28;
constexpr double kMaxUpOrDown = 240;
constexpr double kStep = 20;
constexpr double kUnseenWeight = 60;

double AreaOf(const QRectF& rect) { return rect.width() * rect.height(); }

}  // namespace

QRectF CardPlacement::Reach(const QPointF& port, double widest) {
  const double aside = widest + 2 * kDistance;
  return {port.x() - aside, port.y() - kMaxUpOrDown, 2 * aside, 3 * kMaxUpOrDown};
}

void CardPlacement::Avoid(const QRectF& rect, double weight) { things_.push_back({rect, weight}); }

double CardPlacement::HiddenBy(const QRectF& card) const {
  double hidden = 0;
  for (const Obstacle& thing : things_) hidden += thing.weight * AreaOf(card & thing.rect);
  if (!visible_.isEmpty()) hidden += kUnseenWeight * (AreaOf(card) - AreaOf(card & visible_));
  return hidden;
}

CardPlacement::Corner CardPlacement::Find(const QSizeF& size) const {
  Corner found;
  bool any = false;
  for (const double x : {kDistance, -size.width() / 2, -size.width() - kDistance}) {
    for (double y = -kMaxUpOrDown; y <= kMaxUpOrDown; y += kStep) {
      const QPointF corner = port_ + QPointF(x, y);
      const bool covers_port = QRectF(corner, size).adjusted(-8, -8, 8, 8).contains(port_);
      const double away = std::abs(y + size.height() / 2) + (x == kDistance ? 0 : 120);
      const double hidden = HiddenBy({corner, size});
      const double cost = hidden + 3 * away + (covers_port ? 1e6 : 0);
      if (any && cost >= found.cost) continue;
      any = true;
      found = {corner, hidden, cost};
    }
  }
  return found;
}

}  // namespace tendon::gui
