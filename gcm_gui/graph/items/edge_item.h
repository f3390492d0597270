#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>
#include <tendon/base/name.h>

#include <QGraphicsItem>
#include <QPainterPath>
#include <QString>

namespace tendon::gui {

/// A connection, drawn from the provided port to the required one.
class EdgeItem : public QGraphicsItem {
 public:
  /// kPreview is a connection that was not requested yet.
  enum class Look { kActive, kPending, kFailed, kStale, kPreview };
  enum { Type = UserType + 4 };

  EdgeItem();

  void show(const QPointF& from, const QPointF& to, Look look, const QString& reason = {});
  /// Sets both interfaces. The required interface is the name of the edge.
  void setEnds(const InterfaceName& required, const InterfaceName& provided);
  void setSelected(bool selected);
  /// Sets the problem of a working connection; empty if there is none.
  void setWarning(const QString& warning);
  /// Raises the item above the DimmingItem.
  void setRaised(bool raised);

  [[nodiscard]] const QString& required() const { return required_; }
  [[nodiscard]] const QString& provided() const { return provided_; }
  [[nodiscard]] const InterfaceName& name() const { return name_; }
  [[nodiscard]] Look look() const { return look_; }
  [[nodiscard]] const QString& warning() const { return warning_; }
  [[nodiscard]] const QPainterPath& path() const { return path_; }
  /// True if the connection is pending or has failed, so that there is a reason to show.
  [[nodiscard]] bool isBroken() const { return look_ == Look::kFailed || look_ == Look::kPending; }

  [[nodiscard]] int type() const override { return Type; }
  [[nodiscard]] QRectF boundingRect() const override;
  [[nodiscard]] QPainterPath shape() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void draw(QPainter* painter);
  void order();
  void showTip();
  void paintReason(QPainter& painter) const;

  InterfaceName name_;  // the required interface
  QString required_;
  QString provided_;
  QPointF from_;
  QPointF to_;
  QPainterPath path_;
  Look look_ = Look::kActive;
  QString reason_;
  QString warning_;
  bool selected_ = false;
  bool raised_ = false;
};

}  // namespace tendon::gui
