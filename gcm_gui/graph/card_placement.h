#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <vector>

namespace tendon::gui {

/// Finds the position beside a port at which a card hides as little as possible.
class CardPlacement {
 public:
  /// Returns the area that contains every possible position of a card of at most this width beside
  /// `port`.
  static QRectF Reach(const QPointF& port, double widest);

  /// `visible` is the visible part of the scene; an empty rectangle means the whole scene.
  CardPlacement(const QPointF& port, const QRectF& visible) : port_(port), visible_(visible) {}

  /// Marks an area that should stay visible; `weight` is the cost per hidden unit of area.
  void Avoid(const QRectF& rect, double weight);

  struct Corner {
    QPointF corner;
    double hidden = 0;  ///< hidden area times weight
    double cost = 0;    ///< `hidden`, plus a cost for the distance from the port
  };
  [[nodiscard]] Corner Find(const QSizeF& size) const;

 private:
  struct Obstacle {
    QRectF rect;
    double weight;
  };
  [[nodiscard]] double HiddenBy(const QRectF& card) const;

  QPointF port_;
  QRectF visible_;
  std::vector<Obstacle> things_;
};

}  // namespace tendon::gui
