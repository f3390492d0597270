#include <gcm_gui/graph/items/dimming_item.h>

#include <gcm_gui/graph/layout/node_metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QPainter>
#include <QStyleOptionGraphicsItem>

namespace tendon::gui {
namespace {

constexpr double kMaxOpaque = 0.68;

}  // namespace

DimmingItem::DimmingItem() {
  setZValue(kDimming);
  setAcceptedMouseButtons(Qt::NoButton);
  setFlag(ItemUsesExtendedStyleOption);
  setVisible(false);
}

void DimmingItem::cover(const QRectF& rect) {
  if (rect == rect_) return;
  prepareGeometryChange();
  rect_ = rect;
}

void DimmingItem::setStrength(double strength) {
  strength_ = strength;
  setVisible(strength > 0);
  update();
}

void DimmingItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  painter->fillRect(option->exposedRect,
                    Theme::instance().color(Token::kCanvas, kMaxOpaque * strength_));
}

}  // namespace tendon::gui
