#pragma once

#include <gcm_gui/connect/connect_mode.h>
#include <gcm_gui/graph/emphasis/emphasis.h>

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

namespace tendon::gui {

class CardItem;
class EdgeItem;
class GraphScene;

/// What the pointer rests on stands out with all that it is connected to, and a connection tells on
/// a card how it does. Not while a connection is made, which has its own marks.
class GraphHover : public QObject {
  Q_OBJECT

 public:
  /// The scene owns it.
  GraphHover(GraphScene& scene, Emphasis& emphasis, const ConnectMode& mode);

  /// Null while there is none.
  [[nodiscard]] const CardItem* card() const { return card_; }

 public Q_SLOTS:
  /// The pointer is on this component, interface, or connection (of this required interface);
  /// empty for none of them. The first one stands out once the pointer has rested for a moment.
  void point(const QString& path);
  /// The same at once, for who walks by keys.
  void pointNow(const QString& path);
  /// How the connection of this required interface does, in lines; shown if it is pointed at.
  void showReadout(const tendon::InterfaceName& required, const QStringList& lines);

 Q_SIGNALS:
  /// Somebody wants to know how the connection of this required interface does; empty: no longer.
  void connectionPointed(const QString& required);

 private:
  void stand();
  void refresh();
  void forgetCard();
  [[nodiscard]] const EdgeItem* pointedEdge() const;
  [[nodiscard]] Emphasis::Names neighbours() const;

  GraphScene& scene_;
  Emphasis& emphasis_;
  const ConnectMode& mode_;
  QTimer soon_;
  QString pointed_;
  QString asked_;  // about which a readout is wanted
  CardItem* card_ = nullptr;
  QStringList lines_;
};

}  // namespace tendon::gui
