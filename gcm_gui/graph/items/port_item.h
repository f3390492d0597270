#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>

#include <QGraphicsItem>
#include <QString>

namespace tendon::gui {

/// One interface of a component, drawn as a disc on the edge of the node, with the name inside the
/// node. The disc is filled if the interface is connected. The item's position is the centre of the
/// disc; the whole item receives clicks.
class PortItem : public QGraphicsItem {
 public:
  enum class Role { kPlain, kChosen, kCandidate, kUnfit };
  enum { Type = UserType + 1 };

  explicit PortItem(QGraphicsItem* parent);

  void show(const PortPicture& picture, double node_width, bool stale);
  /// Sets the role in connect mode. `number` is the digit key that picks the port; 0 for none.
  void setRole(Role role, int number = 0);

  [[nodiscard]] const PortName& port() const { return picture_.port; }
  [[nodiscard]] Role role() const { return role_; }
  [[nodiscard]] int number() const { return number_; }

  [[nodiscard]] int type() const override { return Type; }
  [[nodiscard]] QRectF boundingRect() const override;
  [[nodiscard]] QPainterPath shape() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 protected:
  void hoverEnterEvent(QGraphicsSceneHoverEvent* event) override;
  void hoverLeaveEvent(QGraphicsSceneHoverEvent* event) override;

 private:
  void draw(QPainter* painter);
  [[nodiscard]] QRectF clickRect() const;
  void paintDisc(QPainter& painter) const;
  void paintRings(QPainter& painter) const;

  PortPicture picture_;
  QString label_;
  double node_width_ = 0;
  Role role_ = Role::kPlain;
  int number_ = 0;
  bool stale_ = false;
  bool hovered_ = false;
};

}  // namespace tendon::gui
