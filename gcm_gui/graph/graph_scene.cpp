#include <gcm_gui/graph/graph_scene.h>

#include <gcm_gui/graph/card_placement.h>
#include <gcm_gui/graph/graph_hover.h>
#include <gcm_gui/graph/highlight.h>
#include <gcm_gui/graph/items/card_item.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/items/process_item.h>
#include <gcm_gui/graph/layout/layout_worker.h>
#include <gcm_gui/graph/layout/node_metrics.h>
#include <gcm_gui/graph/layout/node_positions.h>
#include <gcm_gui/graph/layout_animation.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/theme.h>

#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <array>
#include <utility>

namespace tendon::gui {
namespace {

constexpr std::array kCardWidths{320.0, 260.0, 210.0};
constexpr std::size_t kMaxGliding = 60;  // components; a larger system is moved without animation
constexpr qsizetype kReasonsAsked = 2;
// Lines on a card that appears without a request of the user.
constexpr qsizetype kReasonsUnasked = 1;

QStringList FirstOf(const QStringList& reasons, qsizetype count) {
  QStringList first = reasons.mid(0, count);
  if (reasons.size() > count) first += Words::tr("and %1 more").arg(reasons.size() - count);
  return first;
}

/// Deletes the items whose keys are not in `kept`.
template <typename Items, typename Keys>
void ForgetBut(Items& items, const Keys& kept) {
  for (auto it = items.begin(); it != items.end();) {
    if (kept.contains(it->first)) {
      ++it;
    } else {
      delete it->second;
      it = items.erase(it);
    }
  }
}

// The suffix of the key of a refused edge. Without the suffix, a working edge could have the same
// key.
const QString kRefusedKey = QStringLiteral(" refused");

QString CardTitle(const PortName& port) {
  return ToQString(port.name.component) + QStringLiteral(" / ") + ToQString(port.name.interface) +
         Words::tr(" does not fit");
}

}  // namespace

GraphScene::GraphScene(const CatalogueStore& store, const Selection& selection,
                       const ConnectMode& mode, QObject* parent)
    : QGraphicsScene(parent),
      store_(store),
      selection_(selection),
      mode_(mode),
      layout_(new LayoutWorker(this)),
      animation_(new LayoutAnimation(this)),
      preview_(new EdgeItem),
      highlight_(new Highlight(*this)),
      hover_(new GraphHover(*this, *highlight_, mode)),
      node_positions_(new NodePositions(this)) {
  preview_->setVisible(false);
  addItem(preview_);
  setBackgroundBrush(Theme::instance().color(Token::kCanvas));
  connect(&Theme::instance(), &Theme::changed, this, [this] {
    setBackgroundBrush(Theme::instance().color(Token::kCanvas));
    update();
  });
  connect(&store, &CatalogueStore::changed, this, Guarded(this, &GraphScene::showCatalogue));
  connect(&selection, &Selection::changed, this, Guarded(this, &GraphScene::showSelection));
  connect(&mode, &ConnectMode::changed, this, &GraphScene::showMode);
  connect(node_positions_, &NodePositions::changed, this, &GraphScene::showPositions);
  connect(layout_, &LayoutWorker::arranged, this, &GraphScene::showArrangement);
  connect(animation_, &LayoutAnimation::moved, this, [this] { showItems(true); });
  ChangedParts all;
  for (const auto& [name, entry] : store.catalogue().processes()) all.insert({name, {}});
  showCatalogue(store.catalogue(), all);
}

GraphScene::~GraphScene() = default;

PortItem* GraphScene::port(const PortName& name) const {
  const auto it = ports_.find(name);
  return it == ports_.end() ? nullptr : it->second;
}

ComponentItem* GraphScene::component(const QString& path) const {
  const auto it = components_.find(path);
  return it == components_.end() ? nullptr : it->second;
}

std::vector<PortItem*> GraphScene::ports() const {
  std::vector<PortItem*> items;
  for (const auto& [name, item] : ports_) items.push_back(item);
  return items;
}

const EdgeItem* GraphScene::edge(const QString& required) const {
  auto it = edges_.find(required);
  if (it == edges_.end()) it = edges_.find(required + kRefusedKey);
  return it == edges_.end() ? nullptr : it->second;
}

bool GraphScene::isArranging() const { return layout_->isAtWork(); }

void GraphScene::showCatalogue(const Catalogue& catalogue, const ChangedParts& touched) {
  layout_->arrange(updater_.update(catalogue, touched), manualPositions());
  if (layout_->isAtWork()) showItems(false);  // shows only the items that already have a position
}

/// Shows the latest arrangement. During a drag, items follow the pointer at once. In a large
/// system, items move without animation, because drawing it would take too long.
void GraphScene::showArrangement(bool moved) {
  if (moved) {
    const Arrangement& to = layout_->arrangement();
    const bool is_large = static_cast<std::size_t>(to.nodes.size()) > kMaxGliding;
    carried_.empty() && !is_large ? animation_->goTo(to) : animation_->jumpTo(to);
  }
  showItems(moved);
}

void GraphScene::showItems(bool moved) {
  showProcesses();
  showEdges();
  showSelection();
  showMode();
  if (moved) showContents();
  Q_EMIT shown();
}

std::map<QString, QPointF> GraphScene::manualPositions() const {
  auto positions = carried_;
  positions.insert(node_positions_->all().begin(), node_positions_->all().end());
  return positions;
}

void GraphScene::showPositions() { layout_->move(updater_.picture(), manualPositions()); }

void GraphScene::carry(const std::map<QString, QPointF>& positions) {
  if (positions == carried_) return;
  carried_ = positions;
  showPositions();
}

void GraphScene::showContents() {
  QRectF contents;
  for (const auto& [name, item] : processes_) contents |= item->sceneBoundingRect();
  if (contents == contents_) return;
  contents_ = contents;
  Q_EMIT contentsMoved();
}

void GraphScene::showProcesses() {
  std::set<QString> processes;
  std::set<QString> components;
  bool other_ports = false;
  const Arrangement& now = animation_->now();
  for (const auto& process : updater_.picture().processes) {
    const auto rect = now.boxes.constFind(process.name);
    if (rect == now.boxes.constEnd()) continue;
    processes.insert(process.name);
    ProcessItem*& box = processes_[process.name];
    if (box == nullptr) addItem(box = new ProcessItem);
    box->setNow(now_);
    box->show(process, *rect);
    const bool stale = outdated_ || IsGone(process.state);
    for (const auto& node : process.nodes) {
      const auto place = now.nodes.constFind(node.path);
      if (place == now.nodes.constEnd()) continue;
      components.insert(node.path);
      ComponentItem*& item = components_[node.path];
      if (item == nullptr) addItem(item = new ComponentItem);
      if (item->show(node, *place, stale)) other_ports = true;
    }
  }
  ForgetBut(processes_, processes);
  if (!other_ports && components.size() == components_.size()) return;
  ForgetBut(components_, components);
  ports_.clear();
  for (const auto& [path, component] : components_) {
    for (PortItem* item : component->ports()) ports_[item->port()] = item;
  }
}

EdgeItem::Look GraphScene::lookOf(const ConnectionDescription& connection) const {
  switch (connection.state) {
    case ConnectionState::kFailed:
      return EdgeItem::Look::kFailed;
    case ConnectionState::kPending:
      return EdgeItem::Look::kPending;
    case ConnectionState::kActive:
      break;
  }
  const auto is_gone = [&](const InterfaceName& end) {
    const ProcessEntry* entry = store_.catalogue().FindProcess(end.process);
    return entry == nullptr || IsGone(entry->process.state);
  };
  const bool stale = outdated_ || is_gone(connection.required) || is_gone(connection.provided);
  return stale ? EdgeItem::Look::kStale : EdgeItem::Look::kActive;
}

void GraphScene::showEdges() {
  std::set<QString> kept;
  const auto show = [&](const InterfaceName& required, const InterfaceName& provided,
                        EdgeItem::Look look, const QString& reason, const QString& suffix = {}) {
    const PortItem* to = port({Side::kRequired, required});
    const PortItem* from = port({Side::kProvided, provided});
    if (to == nullptr || from == nullptr) return;
    const QString key = ToQString(ToString(required));
    kept.insert(key + suffix);
    EdgeItem*& item = edges_[key + suffix];
    if (item == nullptr) addItem(item = new EdgeItem);
    item->setEnds(required, provided);
    item->show(from->scenePos(), to->scenePos(), look, reason);
  };
  for (const auto& [required, provided] : requested_) {
    show(required, provided, EdgeItem::Look::kPending, Words::tr("connecting …"));
  }
  for (const auto& edge : updater_.picture().edges) {
    if (requested_.contains(edge.required)) continue;  // hidden, because it will be replaced
    show(edge.required, edge.provided, lookOf(edge), ToQString(edge.reason));
  }
  for (const auto& [required, refused] : refused_) {
    if (requested_.contains(required)) continue;  // hidden, because it was requested again
    show(required, refused.provided, EdgeItem::Look::kFailed, refused.reason, kRefusedKey);
  }
  ForgetBut(edges_, kept);
}

void GraphScene::showWarning(const InterfaceName& required, const QString& warning) {
  const auto it = edges_.find(ToQString(ToString(required)));
  if (it != edges_.end()) it->second->setWarning(warning);
}

void GraphScene::showRefused(const RefusedConnections::ByRequired& refused) {
  refused_ = refused;
  showEdges();
  Q_EMIT shown();
}

void GraphScene::showRequested(const InterfaceName& required, const InterfaceName& provided) {
  requested_[required] = provided;
  showEdges();
  Q_EMIT shown();
}

void GraphScene::forgetRequested(const InterfaceName& required) {
  if (requested_.erase(required) == 0) return;
  showEdges();
  Q_EMIT shown();
}

void GraphScene::showSelection() {
  const QString current = selection_.current();
  const QString component = current.section('/', 0, 1);
  for (const auto& [path, item] : components_) item->setSelected(path == component);
  for (const auto& [name, item] : processes_) item->setSelected(name == current);
  const QString interface = current.section('.', 0, 0);
  for (const auto& [key, item] : edges_) item->setSelected(item->required() == interface);
}

void GraphScene::showMode() {
  if (!mode_.active() && !std::exchange(mode_shown_, false)) return;
  mode_shown_ = mode_.active();
  if (!mode_shown_) pointed_.reset();
  showRoles();
  showPreview();
  showCards();
}

void GraphScene::showRoles() {
  for (const auto& [name, item] : ports_) {
    if (!mode_.active()) {
      item->setRole(PortItem::Role::kPlain);
      continue;
    }
    const PortCandidate* candidate = mode_.find(name);
    if (name == mode_.chosen()) {
      item->setRole(PortItem::Role::kChosen);
    } else if (candidate != nullptr && candidate->fits()) {
      item->setRole(PortItem::Role::kCandidate, candidate->number);
    } else {
      item->setRole(PortItem::Role::kUnfit);
    }
  }
}

void GraphScene::showPreview() {
  const PortItem* chosen = mode_.active() ? port(mode_.chosen()) : nullptr;
  const PortCandidate* shown = mode_.active() ? mode_.best() : nullptr;
  if (chosen != nullptr && pointed_) {
    const PortCandidate* pointed = mode_.find(*pointed_);
    if (pointed != nullptr && pointed->fits()) shown = pointed;
  }
  const PortItem* other = shown == nullptr ? nullptr : port(shown->port);
  preview_->setVisible(chosen != nullptr && other != nullptr);
  if (!preview_->isVisible()) return;
  const bool from_required = mode_.chosen().side == Side::kRequired;
  const PortItem* from = from_required ? other : chosen;
  const PortItem* to = from_required ? chosen : other;
  preview_->show(from->scenePos(), to->scenePos(), EdgeItem::Look::kPreview);
}

void GraphScene::showCards() {
  for (CardItem* card : cards_) delete card;
  cards_.clear();
  const bool active = mode_.active();
  const PortCandidate* look_alike = active ? mode_.bestLookAlike() : nullptr;
  const PortCandidate* pointed = active && pointed_ ? mode_.find(*pointed_) : nullptr;
  if (pointed == nullptr || pointed->fits()) {
    if (look_alike != nullptr) addCard(*look_alike, kReasonsUnasked);
  } else if (!addCard(*pointed, kReasonsAsked)) {
    Q_EMIT refusalPointed(CardTitle(pointed->port), pointed->reasons());
    return;
  }
  Q_EMIT refusalPointed({}, {});
}

bool GraphScene::addCard(const PortCandidate& candidate, qsizetype reasons) {
  const PortItem* item = port(candidate.port);
  if (item == nullptr) return false;
  auto* card = new CardItem;
  const QString title = CardTitle(candidate.port);
  const QStringList lines = FirstOf(candidate.reasons(), reasons);
  const CardPlacement place = placeBeside(item->scenePos());
  std::optional<CardPlacement::Corner> best;
  double best_width = 0;
  for (const double width : kCardWidths) {
    card->setTexts(title, lines, width);
    const CardPlacement::Corner found = place.Find(card->size());
    if (best && found.cost >= best->cost) continue;
    best = found;
    best_width = width;
  }
  card->setTexts(title, lines, best_width);
  if (best->hidden > 0) {
    delete card;
    return false;
  }
  card->place(best->corner, item->scenePos());
  addItem(card);
  cards_.push_back(card);
  return true;
}

CardPlacement GraphScene::placeBeside(const QPointF& point) const {
  const QRectF reach = CardPlacement::Reach(point, kCardWidths.front());
  CardPlacement place(point, visible_);
  const auto avoid = [&](const QRectF& rect, double weight) {
    if (rect.intersects(reach)) place.Avoid(rect, weight);
  };
  for (const auto& [path, item] : components_) avoid(item->sceneRect(), 20);
  for (const auto& [name, item] : processes_) avoid(item->sceneBoundingRect(), 2);
  for (const auto& [name, item] : ports_) {
    // Only the ports that the user can pick must stay visible.
    if (item->role() == PortItem::Role::kPlain || item->role() == PortItem::Role::kUnfit) continue;
    avoid(QRectF(-20, -30, 50, 50).translated(item->scenePos()), 50);
  }
  for (const auto& [required, edge] : edges_) avoid(edge->sceneBoundingRect(), 0.3);
  if (preview_->isVisible()) avoid(preview_->sceneBoundingRect(), 0.6);
  return place;
}

void GraphScene::point(const std::optional<PortName>& port) {
  if (port == pointed_) return;
  pointed_ = port;
  if (!mode_.active()) return;
  showPreview();
  showCards();
}

void GraphScene::helpEvent(QGraphicsSceneHelpEvent* event) {
  // While there are cards, no tool tip is shown: it would cover the cards, which contain more
  // information.
  if (!mode_.active() && hover_->card() == nullptr) QGraphicsScene::helpEvent(event);
}

void GraphScene::drawForeground(QPainter* painter, const QRectF& rect) {
  const double scale =
      QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform());
  if (scale >= kFarAway) return;
  for (const auto& [name, item] : processes_) {
    if (item->sceneBoundingRect().intersects(rect)) item->paintFarTitle(*painter, scale);
  }
}

void GraphScene::setNow(qint64 now) {
  now_ = now;
  for (const auto& [name, item] : processes_) item->setNow(now);
}

void GraphScene::setOutdated(bool outdated) {
  if (outdated == outdated_) return;
  outdated_ = outdated;
  showItems(false);
}

}  // namespace tendon::gui
