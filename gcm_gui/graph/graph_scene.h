#pragma once

#include <gcm_gui/connect/connect_mode.h>
#include <gcm_gui/graph/items/edge_item.h>
#include <gcm_gui/graph/layout/picture_updater.h>
#include <gcm_gui/models/selection.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/why/refusals.h>

#include <QGraphicsScene>
#include <QHash>
#include <QString>
#include <QStringList>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace tendon::gui {

class CardItem;
class CardPlace;
class ComponentItem;
class Emphasis;
class Glide;
class GraphHover;
class GraphPlaces;
class LayoutWorker;
class PortItem;
class ProcessItem;

/// The system as boxes, nodes and edges: shows the catalogue, the selection and the connect mode,
/// and decides nothing. GUI thread.
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
  /// By the path of the required interface; those that were refused beside one that stands, too.
  [[nodiscard]] const std::map<QString, EdgeItem*>& edges() const { return edges_; }
  /// Of the connection of a required interface, or of one that was refused; null without either.
  [[nodiscard]] const EdgeItem* edge(const QString& required) const;
  [[nodiscard]] const std::vector<CardItem*>& cards() const { return cards_; }
  /// Places are looked for; what has come has none yet.
  [[nodiscard]] bool isArranging() const;
  /// Around all nodes and boxes.
  [[nodiscard]] QRectF contents() const { return contents_; }
  [[nodiscard]] Emphasis& emphasis() const { return *emphasis_; }
  [[nodiscard]] GraphHover& hover() const { return *hover_; }
  /// Where the user has put components.
  [[nodiscard]] GraphPlaces& places() const { return *places_; }
  /// For a card about this point.
  [[nodiscard]] CardPlace placeBeside(const QPointF& point) const;

 public Q_SLOTS:
  /// A dashed edge until forgotten, while a request for it is under way.
  void showRequested(const tendon::InterfaceName& required, const tendon::InterfaceName& provided);
  void forgetRequested(const tendon::InterfaceName& required);
  /// Shown while it is told: of a connection that stands.
  void showWarning(const tendon::InterfaceName& required, const QString& warning);
  /// Components that are under way to these places, by path, before those of places().
  void carry(const std::map<QString, QPointF>& places);
  /// Stay as failed edges until they are over.
  void showRefused(const tendon::gui::Refusals::ByRequired& refused);
  /// The pointer is on this port: if it does not fit, a card says why, or refusalPointed().
  void point(const std::optional<tendon::gui::PortName>& port);
  /// Where cards can be seen.
  void setVisible(const QRectF& visible) { visible_ = visible; }
  void setNow(qint64 now);
  /// Nothing is known any more of what there is: all of it is shown as it was, grey.
  void setOutdated(bool outdated);

 Q_SIGNALS:
  void contentsMoved();
  /// Something of what there is, or of how it is, is shown anew.
  void shown();
  /// The pointer is on a port that does not fit, and a card would hide something; without a title:
  /// no longer.
  void refusalPointed(const QString& title, const QStringList& reasons);

 protected:
  void helpEvent(QGraphicsSceneHelpEvent* event) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;

 private:
  void showCatalogue(const Catalog& catalogue, const Touched& touched);
  void showItems(bool moved);
  void showArrangement(bool moved);
  void showContents();
  void showPlaces();
  [[nodiscard]] std::map<QString, QPointF> placesByHand() const;
  void showProcesses();
  void showEdges();
  void showSelection();
  void showMode();
  void showRoles();
  void showPreview();
  void showCards();
  /// False where each place would hide something: there is no card then.
  bool addCard(const Candidate& candidate, qsizetype reasons);
  [[nodiscard]] EdgeItem::Look lookOf(const ConnectionDescription& connection) const;

  const CatalogueStore& store_;
  const Selection& selection_;
  const ConnectMode& mode_;
  PictureUpdater updater_;
  LayoutWorker* layout_;
  Glide* glide_;
  std::map<QString, ProcessItem*> processes_;
  std::map<QString, ComponentItem*> components_;
  std::map<PortName, PortItem*> ports_;
  std::map<QString, EdgeItem*> edges_;  // by edge key
  std::map<InterfaceName, InterfaceName> requested_;
  Refusals::ByRequired refused_;
  EdgeItem* preview_;
  Emphasis* emphasis_;
  GraphHover* hover_;
  GraphPlaces* places_;
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
