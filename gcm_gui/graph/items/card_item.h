#pragma once

#include <QGraphicsItem>
#include <QPainterPath>
#include <QString>
#include <QStringList>
#include <vector>

namespace tendon::gui {

/// A small card with information about a point of the graph, such as a port that does not fit, and
/// a thin line from the card to that point.
class CardItem : public QGraphicsItem {
 public:
  CardItem();

  /// Wraps lines at `widest`.
  void setTexts(const QString& title, const QStringList& lines, double widest);
  /// Places the top left corner of the card at `corner`, and the end of the line at `point`. Both
  /// are in scene coordinates.
  void place(const QPointF& corner, const QPointF& point);

  [[nodiscard]] QSizeF size() const { return size_; }
  [[nodiscard]] const QString& title() const { return title_; }
  [[nodiscard]] const QStringList& lines() const { return lines_; }

  [[nodiscard]] QRectF boundingRect() const override;
  /// Returns an empty path, so that the item never receives a click.
  [[nodiscard]] QPainterPath shape() const override { return {}; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void draw(QPainter* painter);
  [[nodiscard]] QPainterPath lineToPort() const;

  QString title_;
  QStringList lines_;
  std::vector<double> heights_;  // of the lines, after wrapping
  QSizeF size_;
  QPointF port_;
};

}  // namespace tendon::gui
