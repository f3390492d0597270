#pragma once

#include <QGraphicsItem>
#include <QPainterPath>
#include <QString>
#include <QStringList>
#include <vector>

namespace tendon::gui {

/// A small card about a point of the graph, such as a port that does not fit, with a thin line from
/// there.
class CardItem : public QGraphicsItem {
 public:
  CardItem();

  /// Lines are wrapped at `widest`.
  void setTexts(const QString& title, const QStringList& lines, double widest);
  /// Its top left corner in the scene, and what it speaks of.
  void place(const QPointF& corner, const QPointF& point);

  [[nodiscard]] QSizeF size() const { return size_; }
  [[nodiscard]] const QString& title() const { return title_; }
  [[nodiscard]] const QStringList& lines() const { return lines_; }

  [[nodiscard]] QRectF boundingRect() const override;
  /// Empty: it is never in the way of a click.
  [[nodiscard]] QPainterPath shape() const override { return {}; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void draw(QPainter* painter);
  [[nodiscard]] QPainterPath lineToPort() const;

  QString title_;
  QStringList lines_;
  std::vector<double> heights_;  // of the lines, each of which may be wrapped
  QSizeF size_;
  QPointF port_;
};

}  // namespace tendon::gui
