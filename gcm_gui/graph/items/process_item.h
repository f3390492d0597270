#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>

#include <QColor>
#include <QGraphicsItem>
#include <cstdint>

namespace tendon::gui {

/// The box around the components of a process. Its border is dashed if the process is lost.
class ProcessItem : public QGraphicsItem {
 public:
  enum { Type = UserType + 3 };

  ProcessItem();

  void show(const ProcessPicture& picture, const QRectF& rect);
  /// Sets the present time in ns since 1970, for texts such as "lost 12 s".
  void setNow(std::int64_t now);
  void setSelected(bool selected);

  [[nodiscard]] const QString& name() const { return name_; }
  [[nodiscard]] QString title() const;
  /// If the scale makes the title inside the box unreadable, draws the title over the upper edge of
  /// the box in its normal size on the screen. `painter` uses scene coordinates.
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
