#pragma once

#include <gcm_gui/graph/items/port_item.h>
#include <gcm_gui/graph/layout/graph_picture.h>
#include <gcm_gui/theme/tokens.h>

#include <QGraphicsItem>
#include <cstddef>
#include <vector>

namespace tendon::gui {

/// A component with its name, its state bar, and its ports as child items.
class ComponentItem : public QGraphicsItem {
 public:
  enum { Type = UserType + 2 };

  ComponentItem();

  /// Shows a component at `rect`, in scene coordinates. `stale` is true if the state is outdated.
  /// Returns true if something has changed.
  bool show(const NodePicture& picture, const QRectF& rect, bool stale);
  void setSelected(bool selected);
  /// Raises the item above the DimmingItem.
  void setRaised(bool raised);

  [[nodiscard]] const QString& path() const { return picture_.path; }
  [[nodiscard]] const std::vector<PortItem*>& ports() const { return ports_; }
  [[nodiscard]] QRectF sceneRect() const { return QRectF(pos(), size_); }
  [[nodiscard]] bool isStale() const { return stale_; }
  /// The colour of the component's state.
  [[nodiscard]] Token token() const;

  [[nodiscard]] int type() const override { return Type; }
  [[nodiscard]] QRectF boundingRect() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void draw(QPainter* painter);
  void showPorts(const std::vector<PortPicture>& ports, Side side, std::size_t& used);

  NodePicture picture_;
  QSizeF size_;
  std::vector<PortItem*> ports_;
  bool stale_ = false;
  bool selected_ = false;
};

}  // namespace tendon::gui
