#pragma once

#include <QGraphicsItem>
#include <QPainterPath>

namespace tendon::gui {

/// A translucent sheet in the background colour that dims the items below it.
class DimmingItem : public QGraphicsItem {
 public:
  DimmingItem();

  /// Sets the covered area, in scene coordinates.
  void cover(const QRectF& rect);
  /// Sets the strength: 0 is invisible, 1 the strongest.
  void setStrength(double strength);
  [[nodiscard]] double strength() const { return strength_; }

  [[nodiscard]] QRectF boundingRect() const override { return rect_; }
  /// Returns an empty path, so that the item never receives a click.
  [[nodiscard]] QPainterPath shape() const override { return {}; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  QRectF rect_;
  double strength_ = 0;
};

}  // namespace tendon::gui
