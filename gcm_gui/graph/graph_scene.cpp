#include <gcm_gui/graph/graph_scene.h>
#include <gcm_gui/graph/items/card_item.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/items/process_item.h>
#include <gcm_gui/models/state_of.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/theme.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tendon::gui {
namespace {

constexpr double kCardDistance = 28;
constexpr std::array kCardWidths{320.0, 260.0, 210.0};
constexpr qsizetype kReasonsAsked = 2;
constexpr qsizetype kReasonsUnasked = 1;  // stays small: it comes without being asked

QStringList FirstOf(const QStringList& reasons, qsizetype count) {
  QStringList first = reasons.mid(0, count);
  if (reasons.size() > count) first += QStringLiteral("and %1 more").arg(reasons.size() - count);
  return first;
}

/// Deletes and forgets the items whose keys are not kept.
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

QString CardTitle(const PortName& port) {
  return ToQString(port.name.component) + QStringLiteral(" / ") + ToQString(port.name.interface) +
         QStringLiteral(" does not fit");
}

}  // namespace

GraphScene::GraphScene(const CatalogueStore& store, const Selection& selection,
                       const ConnectMode& mode, QObject* parent)
    : QGraphicsScene(parent),
      store_(store),
      selection_(selection),
      mode_(mode),
      preview_(new EdgeItem) {
  preview_->setVisible(false);
  addItem(preview_);
  setBackgroundBrush(Theme::instance().color(Token::kCanvas));
  connect(&Theme::instance(), &Theme::changed, this, [this] {
    setBackgroundBrush(Theme::instance().color(Token::kCanvas));
    update();
  });
  connect(&store, &CatalogueStore::changed, this, &GraphScene::showCatalogue);
  connect(&selection, &Selection::changed, this, &GraphScene::showSelection);
  connect(&mode, &ConnectMode::changed, this, &GraphScene::showMode);
  showCatalogue();
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
  const auto it = edges_.find(required);
  return it == edges_.end() ? nullptr : it->second;
}

void GraphScene::showCatalogue() {
  const GraphPicture picture = PictureOf(store_.catalogue());
  layout_.update(picture);
  showProcesses(picture);
  showEdges(picture);
  showSelection();
  showMode();
  QRectF contents;
  for (const auto& [name, item] : processes_) contents |= item->sceneBoundingRect();
  if (contents == contents_) return;
  contents_ = contents;
  Q_EMIT contentsMoved();
}

void GraphScene::showProcesses(const GraphPicture& picture) {
  std::set<QString> processes;
  std::set<QString> components;
  for (const auto& process : picture.processes) {
    processes.insert(process.name);
    ProcessItem*& box = processes_[process.name];
    if (box == nullptr) addItem(box = new ProcessItem);
    box->setNow(now_);
    box->show(process, layout_.process(process.name));
    for (const auto& node : process.nodes) {
      components.insert(node.path);
      ComponentItem*& item = components_[node.path];
      if (item == nullptr) addItem(item = new ComponentItem);
      item->show(node, layout_.node(node.path), IsGone(process.state));
    }
  }
  ForgetBut(components_, components);
  ForgetBut(processes_, processes);
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
  const bool gone = std::any_of(store_.catalogue().processes().begin(),
                                store_.catalogue().processes().end(), [&](const auto& entry) {
                                  const bool is_end = entry.first == connection.required.process ||
                                                      entry.first == connection.provided.process;
                                  return is_end && IsGone(entry.second.process.state);
                                });
  return gone ? EdgeItem::Look::kStale : EdgeItem::Look::kActive;
}

void GraphScene::showEdges(const GraphPicture& picture) {
  std::set<QString> kept;
  const auto show = [&](const InterfaceName& required, const InterfaceName& provided,
                        EdgeItem::Look look, const QString& reason) {
    const PortItem* to = port({Side::kRequired, required});
    const PortItem* from = port({Side::kProvided, provided});
    if (to == nullptr || from == nullptr) return;
    const QString key = ToQString(ToString(required));
    kept.insert(key);
    EdgeItem*& item = edges_[key];
    if (item == nullptr) addItem(item = new EdgeItem);
    item->setRequired(key);
    item->show(from->scenePos(), to->scenePos(), look, reason);
  };
  for (const auto& [required, provided] : requested_) {
    show(required, provided, EdgeItem::Look::kPending, QStringLiteral("connecting …"));
  }
  for (const auto& edge : picture.edges) {
    show(edge.required, edge.provided, lookOf(edge), ToQString(edge.reason));
  }
  ForgetBut(edges_, kept);
}

void GraphScene::showRequested(const InterfaceName& required, const InterfaceName& provided) {
  requested_[required] = provided;
  showEdges(PictureOf(store_.catalogue()));
}

void GraphScene::forgetRequested(const InterfaceName& required) {
  if (requested_.erase(required) > 0) showEdges(PictureOf(store_.catalogue()));
}

void GraphScene::showSelection() {
  const QString current = selection_.current();
  const QString component = current.section('/', 0, 1);
  for (const auto& [path, item] : components_) item->setSelected(path == component);
  for (const auto& [name, item] : processes_) item->setSelected(name == current);
  const QString interface = current.section('.', 0, 0);
  for (const auto& [required, item] : edges_) item->setSelected(required == interface);
}

void GraphScene::showMode() {
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
    const Candidate* candidate = mode_.find(name);
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
  const Candidate* shown = mode_.active() ? mode_.best() : nullptr;
  if (chosen != nullptr && pointed_) {
    const Candidate* pointed = mode_.find(*pointed_);
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
  if (!mode_.active()) return;
  const Candidate* look_alike = mode_.bestLookAlike();
  const Candidate* pointed = pointed_ ? mode_.find(*pointed_) : nullptr;
  if (pointed != nullptr && !pointed->fits()) {
    addCard(*pointed, kReasonsAsked);
  } else if (look_alike != nullptr) {
    addCard(*look_alike, kReasonsUnasked);
  }
}

void GraphScene::addCard(const Candidate& candidate, qsizetype reasons) {
  const PortItem* item = port(candidate.port);
  if (item == nullptr) return;
  auto* card = new CardItem;
  const QString title = CardTitle(candidate.port);
  const QStringList lines = FirstOf(candidate.reasons(), reasons);
  double best_width = kCardWidths.front();
  double least = -1;
  for (const double width : kCardWidths) {
    card->setTexts(title, lines, width);
    const double hidden = placeCard(*card, *item);
    if (least >= 0 && hidden >= least) continue;
    least = hidden;
    best_width = width;
  }
  card->setTexts(title, lines, best_width);
  placeCard(*card, *item);
  addItem(card);
  cards_.push_back(card);
}

double GraphScene::crowding(const QRectF& rect) const {
  double crowding = 0;
  const auto area = [&](const QRectF& other) {
    const QRectF common = rect.intersected(other);
    return common.width() * common.height();
  };
  for (const auto& [path, item] : components_) crowding += 20 * area(item->sceneRect());
  for (const auto& [name, item] : processes_) crowding += 2 * area(item->sceneBoundingRect());
  for (const auto& [name, item] : ports_) {
    // What can be picked stays in sight.
    if (item->role() == PortItem::Role::kPlain || item->role() == PortItem::Role::kUnfit) continue;
    crowding += 50 * area(QRectF(-20, -30, 50, 50).translated(item->scenePos()));
  }
  for (const auto& [required, edge] : edges_) crowding += 0.3 * area(edge->sceneBoundingRect());
  if (preview_->isVisible()) crowding += 0.6 * area(preview_->sceneBoundingRect());
  if (!visible_.isEmpty()) crowding += 60 * (rect.width() * rect.height() - area(visible_));
  return crowding;
}

double GraphScene::placeCard(CardItem& card, const PortItem& port) const {
  const QPointF at = port.scenePos();
  const QSizeF size = card.size();
  QPointF best;
  double least = -1;
  for (const double x : {kCardDistance, -size.width() / 2, -size.width() - kCardDistance}) {
    for (double y = -240; y <= 240; y += 20) {
      const QPointF corner = at + QPointF(x, y);
      const bool covers_port = QRectF(corner, size).adjusted(-8, -8, 8, 8).contains(at);
      const double away = std::abs(y + size.height() / 2) + (x == kCardDistance ? 0 : 120);
      const double cost = crowding({corner, size}) + 3 * away + (covers_port ? 1e6 : 0);
      if (least >= 0 && cost >= least) continue;
      least = cost;
      best = corner;
    }
  }
  card.place(best, at);
  return least;
}

void GraphScene::point(const std::optional<PortName>& port) {
  if (port == pointed_) return;
  pointed_ = port;
  if (!mode_.active()) return;
  showPreview();
  showCards();
}

void GraphScene::helpEvent(QGraphicsSceneHelpEvent* event) {
  // A tip would cover the cards, which say more.
  if (!mode_.active()) QGraphicsScene::helpEvent(event);
}

void GraphScene::setNow(qint64 now) {
  now_ = now;
  for (const auto& [name, item] : processes_) item->setNow(now);
}

}  // namespace tendon::gui
