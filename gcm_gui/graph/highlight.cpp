#include <gcm_gui/graph/highlight.h>

#include <gcm_gui/graph/graph_scene.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/items/dimming_item.h>
#include <gcm_gui/graph/items/edge_item.h>

#include <cstddef>
#include <utility>

namespace tendon::gui {
namespace {

constexpr int kFade = 140;                 // ms
constexpr std::size_t kMaxThatFade = 300;  // components; each step of a fade redraws all of them
constexpr double kAround = 2;  // scene units; the dimmed area is this much larger than the contents

}  // namespace

Highlight::Highlight(GraphScene& scene)
    : QObject(&scene), scene_(scene), dimming_item_(new DimmingItem) {
  scene_.addItem(dimming_item_);
  fade_.setDuration(kFade);
  fade_.setStartValue(0.0);
  fade_.setEndValue(1.0);
  connect(&fade_, &QVariantAnimation::valueChanged, this,
          [this](const QVariant& value) { dimming_item_->setStrength(value.toDouble()); });
  connect(&fade_, &QVariantAnimation::finished, this, &Highlight::raise);
  connect(&scene, &GraphScene::shown, this, &Highlight::raise);
}

double Highlight::dimming() const { return dimming_item_->strength(); }

void Highlight::setPointed(Names names) {
  if (names == pointed_) return;
  pointed_ = std::move(names);
  refresh();
}

void Highlight::setFound(Names names) {
  if (names == found_) return;
  found_ = std::move(names);
  refresh();
}

void Highlight::lift(bool lifted) { dimming_item_->setVisible(!lifted && dimming() > 0); }

void Highlight::refresh() {
  const bool dims = !names().empty();
  raise();
  fade_.setDirection(dims ? QAbstractAnimation::Forward : QAbstractAnimation::Backward);
  if (scene_.components().size() > kMaxThatFade) {
    fade_.stop();
    dimming_item_->setStrength(dims ? 1 : 0);
    raise();
  } else if (fade_.state() != QAbstractAnimation::Running && dimming() != (dims ? 1 : 0)) {
    fade_.start();
  }
}

void Highlight::raise() {
  dimming_item_->cover(scene_.contents().adjusted(-kAround, -kAround, kAround, kAround));
  // The part that was highlighted last stays raised until the fade has ended, so that it is not
  // dimmed.
  if (!names().empty() || dimming() == 0) raised_ = names();
  for (const auto& [path, item] : scene_.components()) {
    item->setRaised(raised_.components.contains(path));
  }
  for (const auto& [key, item] : scene_.edges()) {
    item->setRaised(raised_.edges.contains(item->required()));
  }
}

}  // namespace tendon::gui
