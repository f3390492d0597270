#pragma once

#include <gcm_gui/connect/connect_mode.h>
#include <gcm_gui/diagnosis/refused_connections.h>
#include <gcm_gui/graph/items/edge_item.h>
#include <gcm_gui/graph/layout/picture_updater.h>
#include <gcm_gui/models/selection.h>
#include <gcm_gui/session/catalogue_store.h>

#include <QGraphicsScene>
#include <QHash>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace tendon::gui {

class CardItem;
class CardPlacement;
class ComponentItem;
class Highlight;
class GraphHover;
class NodePositions;
class LayoutAnimation;
class LayoutWorker;
class PortItem;
class ProcessItem;

/// Shows the system as boxes, nodes and edges, with the selection and the connect mode. Contains no
/// logic. GUI thread.
class GraphScene : public QGraphicsScene {
  Q_OBJECT

 public:
  GraphScene(const CatalogueStore& store, const Selection& selection, const ConnectMode& mode,
             QObject* parent = nullptr);
  ~GraphScene() override;

  [[nodiscard]] PortItem* port(const PortName& name) const;
  [[nodiscard]] ComponentItem* component(const QString& path) const;
  [[nodiscard]] std::vector<PortItem*> ports() const;
  [[nodiscard]] const std::map<QString, ComponentItem*>& components() const { return components_; }
  [[nodiscard]] const std::map<QString, ProcessItem*>& processes() const { return processes_; }
  /// All edges by the path of their required interface. If a refused connection is shown beside a
  /// working one, both are included.
  [[nodiscard]] const std::map<QString, EdgeItem*>& edges() const { return edges_; }
  /// Returns the edge of a required interface, whether it works or not; null if there is none.
  [[nodiscard]] const EdgeItem* edge(const QString& required) const;
  /// True while positions are being computed. New items have no position until then.
  [[nodiscard]] bool isArranging() const;
  /// The rectangle around all nodes and boxes.
  [[nodiscard]] QRectF contents() const { return contents_; }
  [[nodiscard]] Highlight& highlight() const { return *highlight_; }
  [[nodiscard]] GraphHover& hover() const { return *hover_; }
  /// The positions that the user has given to components.
  [[nodiscard]] NodePositions& nodePositions() const { return *node_positions_; }
  /// Makes a CardPlacement for a card beside this point.
  [[nodiscard]] CardPlacement placeBeside(const QPointF& point) const;

 public Q_SLOTS:
  /// Shows a dashed edge for a pending request. It stays until forgetRequested().
  void showRequested(const tendon::InterfaceName& required, const tendon::InterfaceName& provided);
  void forgetRequested(const tendon::InterfaceName& required);
  /// Shows a warning on the edge of a working connection.
  void showWarning(const tendon::InterfaceName& required, const QString& warning);
  /// During a drag, shows the components with these paths at these positions instead of the
  /// positions in nodePositions().
  void carry(const std::map<QString, QPointF>& positions);
  /// Shows refused connections as failed edges until the list no longer contains them.
  void showRefused(const tendon::gui::RefusedConnections::ByRequired& refused);
  /// Called when the pointer is on this port. If the port does not fit, a card shows the reasons;
  /// if there is no room for a card, refusalPointed() is emitted.
  void point(const std::optional<tendon::gui::PortName>& port);
  /// Sets the visible part of the scene. Cards are placed within it.
  void setVisible(const QRectF& visible) { visible_ = visible; }
  void setNow(qint64 now);
  /// Pass true while the link to the GCM is lost: everything is then shown grey, in its last known
  /// state.
  void setOutdated(bool outdated);

 Q_SIGNALS:
  void contentsMoved();
  /// Emitted when the shown items or their states have been updated.
  void shown();
  /// Emitted when the pointer is on a port that does not fit, and a card with the reasons would
  /// hide something. An empty title means that the pointer has left the port.
  void refusalPointed(const QString& title, const QStringList& reasons);

 protected:
  void helpEvent(QGraphicsSceneHelpEvent* event) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;

 private:
  void showCatalogue(const Catalogue& catalogue, const ChangedParts& touched);
  void showItems(bool moved);
  void showArrangement(bool moved);
  void showContents();
  void showPositions();
  [[nodiscard]] std::map<QString, QPointF> manualPositions() const;
  void showProcesses();
  void showEdges();
  void showSelection();
  void showMode();
  void showRoles();
  void showPreview();
  void showCards();
  /// Adds a card with the reasons of a candidate. Returns false, and adds no card, if it would hide
  /// something at every position.
  bool addCard(const PortCandidate& candidate, qsizetype reasons);
  [[nodiscard]] EdgeItem::Look lookOf(const ConnectionDescription& connection) const;

  const CatalogueStore& store_;
  const Selection& selection_;
  const ConnectMode& mode_;
  PictureUpdater updater_;
  LayoutWorker* layout_;
  LayoutAnimation* animation_;
  std::map<QString, ProcessItem*> processes_;
  std::map<QString, ComponentItem*> components_;
  std::map<PortName, PortItem*> ports_;
  std::map<QString, EdgeItem*> edges_;  // by edge key
  std::map<InterfaceName, InterfaceName> requested_;
  RefusedConnections::ByRequired refused_;
  EdgeItem* preview_;
  Highlight* highlight_;
  GraphHover* hover_;
  NodePositions* node_positions_;
  std::map<QString, QPointF> carried_;
  std::vector<CardItem*> cards_;
  std::optional<PortName> pointed_;
  QRectF contents_;
  QRectF visible_;
  std::int64_t now_ = 0;
  bool outdated_ = false;
  bool mode_shown_ = false;
};

}  // namespace tendon::gui
