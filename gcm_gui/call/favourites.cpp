#include <gcm_gui/call/favourites.h>

#include <gcm_gui/files/file_writer.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace tendon::gui {

Favourites::Favourites(const QString& file, QObject* parent) : QObject(parent), file_(file) {
  load();
}

void Favourites::load() {
  if (file_.isEmpty()) return;
  QDir().mkpath(QFileInfo(file_).path());
  QFile file(file_);
  if (!file.open(QIODevice::ReadOnly)) return;
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

void Favourites::keep() {
  if (file_.isEmpty()) return;
  QJsonArray list;
  for (const auto& [path, argument] : all_) {
    list.append(QJsonObject{{"path", path}, {"argument", argument}});
  }
  const QJsonObject document{{"schema", 1}, {"favourites", list}};
  FileWriter::instance().write(file_, QJsonDocument(document).toJson(), this,
                               [this](const QString& refusal) {
                                 if (!refusal.isEmpty()) Q_EMIT notice(NotSaved(file_, refusal));
                               });
}

}  // namespace tendon::gui
