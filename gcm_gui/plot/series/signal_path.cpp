#include <gcm_gui/plot/series/signal_path.h>

#include <QMimeData>
#include <QStringList>

namespace tendon::gui {
namespace {

qsizetype EndOfSource(const QString& path) {
  const qsizetype dot = path.indexOf('.', path.lastIndexOf('/') + 1);
  return dot < 0 ? path.size() : dot;
}

}  // namespace

QString SourceOf(const QString& path) { return path.left(EndOfSource(path)); }

QString ShortName(const QString& path) {
  const QStringList parts = SourceOf(path).split('/');
  if (parts.size() < 3) return path;
  const QString& component = parts.at(parts.size() - 2);
  const QString& table = parts.last();
  const QString member = path.mid(EndOfSource(path));
  if (table == "state") return component + member;
  return component + '.' + (table.startsWith("state-") ? table.mid(6) : table) + member;
}

QString ColumnOf(const QString& path) {
  const QString member = path.mid(EndOfSource(path) + 1);
  return member.section('.', 0, 0).section('[', 0, 0);
}

QByteArray EncodedPaths(const QList<CurveKey>& keys) {
  QStringList lines;
  for (const CurveKey& key : keys) lines << key.path + '\t' + key.unit;
  return lines.join('\n').toUtf8();
}

QList<CurveKey> PathsIn(const QMimeData& data) {
  QList<CurveKey> keys;
  const QString text = QString::fromUtf8(data.data(kPathMimeType));
  for (const QString& line : text.split('\n', Qt::SkipEmptyParts)) {
    const CurveKey key{.path = line.section('\t', 0, 0).trimmed(),
                       .unit = line.section('\t', 1, 1).trimmed()};
    if (!key.path.isEmpty()) keys << key;
  }
  return keys;
}

}  // namespace tendon::gui
