#include <gcm_gui/files/saved_settings.h>

#include <gcm_gui/files/file_writer.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <iostream>

namespace tendon::gui {
namespace {

QByteArray TextOf(const QHash<QString, QByteArray>& values) {
  QJsonObject all;
  for (auto it = values.begin(); it != values.end(); ++it) {
    all.insert(it.key(), QString::fromLatin1(it->toBase64()));
  }
  return QJsonDocument(QJsonObject{{"schema", 1}, {"values", all}}).toJson();
}

QHash<QString, QByteArray> ValuesIn(const QString& name) {
  QHash<QString, QByteArray> values;
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly)) return values;
  const QJsonObject all =
      QJsonDocument::fromJson(file.readAll()).object().value(QStringLiteral("values")).toObject();
  for (auto it = all.begin(); it != all.end(); ++it) {
    values.insert(it.key(), QByteArray::fromBase64(it->toString().toLatin1()));
  }
  return values;
}

}  // namespace

SavedSettings::SavedSettings(const QString& name) : file_(name) {
  QDir().mkpath(QFileInfo(name).path());
  values_ = ValuesIn(name);
}

void SavedSettings::set(const QString& name, const QByteArray& value) {
  values_.insert(name, value);
  set_.insert(name, value);
  const auto fill = [file = file_, set = set_](QIODevice& device) {
    auto all = ValuesIn(file);
    all.insert(set);
    const QByteArray text = TextOf(all);
    return device.write(text) == text.size();
  };
  const auto report = [file = file_](const QString& refusal) {
    if (refusal.isEmpty()) return;
    std::cerr << "gcm-gui: " << NotSaved(file, refusal).toStdString() << '\n';
  };
  FileWriter::instance().write(file_, fill, QCoreApplication::instance(), report);
}

}  // namespace tendon::gui
