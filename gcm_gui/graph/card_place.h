#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <vector>

namespace tendon::gui {

/// Finds where a card beside a port hides least.
class CardPlace {
 public:
  /// No card of this width or less, at any place, reaches further from its port.
  static QRectF Reach(const QPointF& port, double widest);

  /// `visible`: where cards can be seen; empty for everywhere.
  CardPlace(const QPointF& port, const QRectF& visible) : port_(port), visible_(visible) {}

  /// Something that is better left in sight; `weight` for each unit of its area.
  void Avoid(const QRectF& rect, double weight);

  struct Found {
    QPointF corner;
    double hidden = 0;  ///< area times weight
    double cost = 0;    ///< that, and how far from the port it is
  };
  [[nodiscard]] Found Find(const QSizeF& size) const;

 private:
  struct Thing {
    QRectF rect;
    double weight;
  };
  [[nodiscard]] double HiddenBy(const QRectF& card) const;

  QPointF port_;
  QRectF visible_;
  std::vector<Thing> things_;
};

}  // namespace tendon::gui
