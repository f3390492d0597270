#include <gcm_gui/call/favourites/favourites.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

namespace tendon::gui {

Favourites::Favourites(const QString& file, QObject* parent) : QObject(parent), file_(file) {
  load();
}

void Favourites::load() {
  QFile file(file_);
  if (file_.isEmpty() || !file.open(QIODevice::ReadOnly)) return;
  const QJsonObject document = QJsonDocument::fromJson(file.readAll()).object();
  for (const auto& value : document[QStringLiteral("favourites")].toArray()) {
    const QJsonObject one = value.toObject();
    const Favourite favourite{one[QStringLiteral("path")].toString(),
                              one[QStringLiteral("argument")].toString()};
    if (!favourite.path.isEmpty()) all_.append(favourite);
  }
}

void Favourites::add(const Favourite& favourite) {
  if (all_.contains(favourite)) return;
  all_.append(favourite);
  keep();
  Q_EMIT changed();
}

void Favourites::remove(const Favourite& favourite) {
  if (!all_.removeOne(favourite)) return;
  keep();
  Q_EMIT changed();
}

void Favourites::keep() const {
  if (file_.isEmpty()) return;
  QJsonArray list;
  for (const auto& [path, argument] : all_) {
    list.append(QJsonObject{{"path", path}, {"argument", argument}});
  }
  QDir().mkpath(QFileInfo(file_).path());
  QSaveFile file(file_);
  if (!file.open(QIODevice::WriteOnly)) return;
  file.write(QJsonDocument(QJsonObject{{"schema", 1}, {"favourites", list}}).toJson());
  file.commit();
}

}  // namespace tendon::gui
