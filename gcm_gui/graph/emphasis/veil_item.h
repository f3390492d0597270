#pragma once

#include <QGraphicsItem>
#include <QPainterPath>

namespace tendon::gui {

/// A sheet in the colour of the ground, through which what lies below can still be made out.
class VeilItem : public QGraphicsItem {
 public:
  VeilItem();

  /// What it covers, in the scene.
  void cover(const QRectF& rect);
  /// From 0, which is nothing, to 1.
  void setStrength(double strength);
  [[nodiscard]] double strength() const { return strength_; }

  [[nodiscard]] QRectF boundingRect() const override { return rect_; }
  /// Empty: it is never in the way of a click.
  [[nodiscard]] QPainterPath shape() const override { return {}; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  QRectF rect_;
  double strength_ = 0;
};

}  // namespace tendon::gui
