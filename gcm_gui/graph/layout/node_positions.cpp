#include <gcm_gui/graph/layout/node_positions.h>

#include <gcm_gui/files/file_writer.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tendon::gui {
namespace {

constexpr std::size_t kMaxSteps = 50;
// The maximum number of positions, including positions of systems that were shown earlier.
constexpr std::size_t kMaxPlaces = 20000;
constexpr double kFurthest = 1e6;  // a larger distance is a mistake in the file

QByteArray MapText(const NodePositions::Map& places) {
  QJsonObject all;
  for (const auto& [path, place] : places) all.insert(path, QJsonArray{place.x(), place.y()});
  return QJsonDocument(QJsonObject{{"schema", 1}, {"places", all}}).toJson();
}

NodePositions::Map PlacesIn(const QByteArray& text) {
  NodePositions::Map places;
  const QJsonObject all =
      QJsonDocument::fromJson(text).object().value(QStringLiteral("places")).toObject();
  for (auto it = all.begin(); it != all.end() && places.size() < kMaxPlaces; ++it) {
    const QJsonArray numbers = it->toArray();
    const QPointF place(numbers.at(0).toDouble(kFurthest), numbers.at(1).toDouble(kFurthest));
    if (IsPlausiblePosition(place)) places.emplace(it.key(), place);
  }
  return places;
}

}  // namespace

bool IsPlausiblePosition(const QPointF& position) {
  return std::abs(position.x()) < kFurthest && std::abs(position.y()) < kFurthest;
}

void NodePositions::keepIn(const QString& name) {
  file_ = name;
  QDir().mkpath(QFileInfo(name).path());
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly)) return;
  all_ = PlacesIn(file.readAll());
  Q_EMIT changed();
}

void NodePositions::move(const std::map<QString, QPointF>& moved, const QString& key) {
  Map then = all_;
  for (const auto& [path, place] : moved) then[path] = place;
  if (then == all_) return;
  begin(key);
  all_ = std::move(then);
  keep();
}

void NodePositions::reset() {
  if (all_.empty()) return;
  begin({});
  all_.clear();
  keep();
}

void NodePositions::undo() {
  if (steps_.empty()) return;
  all_ = std::move(steps_.back().before);
  steps_.pop_back();
  keep();
}

void NodePositions::begin(const QString& key) {
  const bool goes_on = is_newest_ && !key.isEmpty() && !steps_.empty() && steps_.back().key == key;
  is_newest_ = true;
  if (goes_on) return;
  if (steps_.size() == kMaxSteps) steps_.erase(steps_.begin());
  steps_.push_back({key, all_});
}

void NodePositions::keep() {
  Q_EMIT changed();
  if (file_.isEmpty()) return;
  FileWriter::instance().write(file_, MapText(all_), this, [this](const QString& refusal) {
    if (!refusal.isEmpty()) Q_EMIT notice(NotSaved(file_, refusal));
  });
}

}  // namespace tendon::gui
