#include <gcm_gui/graph/graph_hover.h>

#include <gcm_gui/graph/card_placement.h>
#include <gcm_gui/graph/graph_scene.h>
#include <gcm_gui/graph/items/card_item.h>
#include <gcm_gui/graph/items/edge_item.h>
#include <gcm_gui/graph/layout/node_metrics.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/models/text.h>

#include <chrono>
#include <utility>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kRest{120};
constexpr double kCardWidth = 320;

QString ComponentPath(const QString& interface) { return interface.section('/', 0, 1); }

}  // namespace

GraphHover::GraphHover(GraphScene& scene, Highlight& highlight, const ConnectMode& mode)
    : QObject(&scene), scene_(scene), highlight_(highlight), mode_(mode) {
  soon_.setSingleShot(true);
  soon_.setInterval(kRest);
  connect(&soon_, &QTimer::timeout, this, Guarded(this, &GraphHover::stand));
  connect(&scene, &GraphScene::shown, this, &GraphHover::refresh);
  connect(&mode, &ConnectMode::changed, this, [this] {
    if (mode_.active()) pointNow({});
  });
}

void GraphHover::point(const QString& path) {
  const QString wanted = mode_.active() ? QString() : path;
  if (wanted == pointed_) return;
  pointed_ = wanted;
  if (pointed_.isEmpty() || !highlight_.names().empty()) return stand();
  soon_.start();
}

void GraphHover::pointNow(const QString& path) {
  pointed_ = mode_.active() ? QString() : path;
  stand();
}

void GraphHover::stand() {
  soon_.stop();
  const EdgeItem* edge = pointedEdge();
  const bool works = edge != nullptr && edge->look() == EdgeItem::Look::kActive;
  const QString asked = works ? edge->required() : QString();
  if (asked != asked_) {
    asked_ = asked;
    forgetCard();
    Q_EMIT connectionPointed(asked_);
  }
  highlight_.setPointed(neighbours());
}

void GraphHover::refresh() {
  if (soon_.isActive() || pointed_.isEmpty()) return;
  stand();
  if (card_ != nullptr) showReadout(pointedEdge()->name(), QStringList(lines_));
}

const EdgeItem* GraphHover::pointedEdge() const {
  return pointed_.isEmpty() ? nullptr : scene_.edge(pointed_);
}

Highlight::Names GraphHover::neighbours() const {
  Highlight::Names names;
  if (pointed_.isEmpty()) return names;
  const bool is_component = pointed_.count('/') == 1;
  for (const auto& [key, edge] : scene_.edges()) {
    const bool touches = is_component
                             ? ComponentPath(edge->required()) == pointed_ ||
                                   ComponentPath(edge->provided()) == pointed_
                             : edge->required() == pointed_ || edge->provided() == pointed_;
    if (!touches) continue;
    names.edges.insert(edge->required());
    names.components.insert(ComponentPath(edge->required()));
    names.components.insert(ComponentPath(edge->provided()));
  }
  return names;
}

void GraphHover::showReadout(const InterfaceName& required, const QStringList& lines) {
  const EdgeItem* edge = pointedEdge();
  if (edge == nullptr || asked_.isEmpty() || asked_ != ToQString(ToString(required))) return;
  if (card_ == nullptr) {
    card_ = new CardItem;
    card_->setZValue(kReadout);
    scene_.addItem(card_);
  }
  lines_ = lines;
  const QPointF middle = edge->path().pointAtPercent(0.5);
  card_->setTexts(edge->required() + QStringLiteral(" → ") + edge->provided(), lines_, kCardWidth);
  card_->place(scene_.placeBeside(middle).Find(card_->size()).corner, middle);
}

void GraphHover::forgetCard() {
  delete std::exchange(card_, nullptr);
  lines_.clear();
}

}  // namespace tendon::gui
