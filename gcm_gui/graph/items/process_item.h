#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>

#include <QColor>
#include <QGraphicsItem>

namespace tendon::gui {

/// The box of a process behind its components; dashed when the process is lost.
class ProcessItem : public QGraphicsItem {
 public:
  enum { Type = UserType + 3 };

  ProcessItem();

  void show(const ProcessPicture& picture, const QRectF& rect);
  /// The time, ns since 1970, for "lost 12 s".
  void setNow(std::int64_t now);
  void setSelected(bool selected);

  [[nodiscard]] const QString& name() const { return name_; }
  [[nodiscard]] QString title() const;
  /// From so far away that the title in the box could not be read: over the box's upper edge, in
  /// its usual size on the screen. `painter` is in scene coordinates.
  void paintFarTitle(QPainter& painter, double scale) const;

  [[nodiscard]] int type() const override { return Type; }
  [[nodiscard]] QRectF boundingRect() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void draw(QPainter* painter);
  [[nodiscard]] QColor titleColor() const;

  QString name_;
  ProcessState state_ = ProcessState::kAlive;
  std::int64_t since_ = 0;
  std::int64_t now_ = 0;
  bool empty_ = false;
  bool selected_ = false;
  QSizeF size_;
};

}  // namespace tendon::gui
