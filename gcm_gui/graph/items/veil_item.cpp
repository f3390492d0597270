#include <gcm_gui/graph/items/veil_item.h>
#include <gcm_gui/graph/layout/node_metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QPainter>
#include <QStyleOptionGraphicsItem>

namespace tendon::gui {
namespace {

constexpr double kMostOpaque = 0.68;

}  // namespace

VeilItem::VeilItem() {
  setZValue(kVeil);
  setAcceptedMouseButtons(Qt::NoButton);
  setFlag(ItemUsesExtendedStyleOption);
  setVisible(false);
}

void VeilItem::cover(const QRectF& rect) {
  if (rect == rect_) return;
  prepareGeometryChange();
  rect_ = rect;
}

void VeilItem::setStrength(double strength) {
  strength_ = strength;
  setVisible(strength > 0);
  update();
}

void VeilItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  painter->fillRect(option->exposedRect,
                    Theme::instance().color(Token::kCanvas, kMostOpaque * strength_));
}

}  // namespace tendon::gui
