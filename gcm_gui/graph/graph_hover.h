#pragma once

#include <gcm_gui/connect/connect_mode.h>
#include <gcm_gui/graph/highlight.h>

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

namespace tendon::gui {

class CardItem;
class EdgeItem;
class GraphScene;

/// Highlights the item under the pointer together with all items connected to it. If the item is a
/// connection, shows its health on a card. Inactive in connect mode, which marks ports in its own
/// way.
class GraphHover : public QObject {
  Q_OBJECT

 public:
  /// The scene owns this object.
  GraphHover(GraphScene& scene, Highlight& highlight, const ConnectMode& mode);

  /// Returns the card; null while no card is shown.
  [[nodiscard]] const CardItem* card() const { return card_; }

 public Q_SLOTS:
  /// Called when the pointer is on this component, interface or connection (given by its required
  /// interface); `path` is empty if the pointer is on none of these. If nothing is highlighted yet,
  /// the item is highlighted only after the pointer has rested for a moment.
  void point(const QString& path);
  /// Like point(), but highlights the item at once. Used for keyboard navigation.
  void pointNow(const QString& path);
  /// Shows the health of the connection of this required interface, if the pointer is on the
  /// connection.
  void showReadout(const tendon::InterfaceName& required, const QStringList& lines);

 Q_SIGNALS:
  /// Requests the health of the connection of this required interface. An empty text ends the
  /// request.
  void connectionPointed(const QString& required);

 private:
  void stand();
  void refresh();
  void forgetCard();
  [[nodiscard]] const EdgeItem* pointedEdge() const;
  [[nodiscard]] Highlight::Names neighbours() const;

  GraphScene& scene_;
  Highlight& highlight_;
  const ConnectMode& mode_;
  QTimer soon_;
  QString pointed_;
  QString asked_;  // the connection whose readout was requested
  CardItem* card_ = nullptr;
  QStringList lines_;
};

}  // namespace tendon::gui
