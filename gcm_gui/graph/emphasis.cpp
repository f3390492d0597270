#include <gcm_gui/graph/emphasis.h>
#include <gcm_gui/graph/graph_scene.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/items/edge_item.h>
#include <gcm_gui/graph/items/veil_item.h>

#include <cstddef>
#include <utility>

namespace tendon::gui {
namespace {

constexpr int kFade = 140;                  // ms
constexpr std::size_t kMostThatFade = 300;  // components; each step of a fade draws all of them
constexpr double kAround = 2;               // scene units, margin of the veil

}  // namespace

Emphasis::Emphasis(GraphScene& scene) : QObject(&scene), scene_(scene), veil_(new VeilItem) {
  scene_.addItem(veil_);
  fade_.setDuration(kFade);
  fade_.setStartValue(0.0);
  fade_.setEndValue(1.0);
  connect(&fade_, &QVariantAnimation::valueChanged, this,
          [this](const QVariant& value) { veil_->setStrength(value.toDouble()); });
  connect(&fade_, &QVariantAnimation::finished, this, &Emphasis::raise);
  connect(&scene, &GraphScene::shown, this, &Emphasis::raise);
}

double Emphasis::veil() const { return veil_->strength(); }

void Emphasis::setPointed(Names names) {
  if (names == pointed_) return;
  pointed_ = std::move(names);
  refresh();
}

void Emphasis::setFound(Names names) {
  if (names == found_) return;
  found_ = std::move(names);
  refresh();
}

void Emphasis::lift(bool lifted) { veil_->setVisible(!lifted && veil() > 0); }

void Emphasis::refresh() {
  const bool dims = !names().empty();
  raise();
  fade_.setDirection(dims ? QAbstractAnimation::Forward : QAbstractAnimation::Backward);
  if (scene_.components().size() > kMostThatFade) {
    fade_.stop();
    veil_->setStrength(dims ? 1 : 0);
    raise();
  } else if (fade_.state() != QAbstractAnimation::Running && veil() != (dims ? 1 : 0)) {
    fade_.start();
  }
}

void Emphasis::raise() {
  veil_->cover(scene_.contents().adjusted(-kAround, -kAround, kAround, kAround));
  // Keeps the last part raised until the veil is gone; otherwise it would be dimmed.
  if (!names().empty() || veil() == 0) raised_ = names();
  for (const auto& [path, item] : scene_.components()) {
    item->setRaised(raised_.components.contains(path));
  }
  for (const auto& [key, item] : scene_.edges()) {
    item->setRaised(raised_.edges.contains(item->required()));
  }
}

}  // namespace tendon::gui
