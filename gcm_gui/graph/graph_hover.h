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

/// Highlights the item under the pointer together with everything connected to it, and shows the
/// health of a connection on a card. Inactive in connect mode, which has its own marks.
class GraphHover : public QObject {
  Q_OBJECT

 public:
  /// The scene owns it.
  GraphHover(GraphScene& scene, Highlight& highlight, const ConnectMode& mode);

  /// Null while there is none.
  [[nodiscard]] const CardItem* card() const { return card_; }

 public Q_SLOTS:
  /// The pointer is on this component, interface or connection (given by its required interface);
  /// empty for none. The first item is highlighted after the pointer has rested for a moment.
  void point(const QString& path);
  /// The same without delay, for keyboard navigation.
  void pointNow(const QString& path);
  /// Shows the health of this required interface's connection, if the pointer is on it.
  void showReadout(const tendon::InterfaceName& required, const QStringList& lines);

 Q_SIGNALS:
  /// Asks for the health of this required interface's connection; empty ends the request.
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
