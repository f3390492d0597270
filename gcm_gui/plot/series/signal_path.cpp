#include <gcm_gui/plot/series/signal_path.h>

#include <gcm_gui/plot/series/shown_time.h>

#include <QDir>
#include <QFileInfo>
#include <QMimeData>
#include <QStringList>
#include <algorithm>

namespace tendon::gui {
namespace {

constexpr QLatin1String kInRecording("//");

struct DraggedFrom {
  QString recording;
  std::int64_t moment_ns = 0;
};

/// The other recording from which values are dragged.
std::optional<DraggedFrom> OtherRecordingIn(const QMimeData& data) {
  const QByteArray origin = data.data(kRecordingMimeType);
  const qsizetype end = origin.indexOf('\n');
  bool is_number = false;
  const qint64 moment = origin.left(std::max<qsizetype>(end, 0)).toLongLong(&is_number);
  const QString file = QString::fromUtf8(origin.mid(end + 1));
  if (!is_number || file.isEmpty() || file == ShownRecording()) return std::nullopt;
  return DraggedFrom{.recording = file, .moment_ns = moment};
}

qsizetype EndOfSource(const QString& path) {
  const qsizetype dot = path.indexOf('.', path.lastIndexOf('/') + 1);
  return dot < 0 ? path.size() : dot;
}

}  // namespace

QString SourceOf(const QString& path) { return path.left(EndOfSource(path)); }

QString RecordedPath(const QString& file, const QString& signal) {
  return QDir::cleanPath(QFileInfo(file).absoluteFilePath()) + kInRecording + signal;
}

QString RecordingOf(const QString& path) {
  return path.left(std::max<qsizetype>(path.lastIndexOf(kInRecording), 0));
}

QString RecordingName(const QString& path) { return QFileInfo(RecordingOf(path)).fileName(); }

QString SignalOf(const QString& path) {
  const qsizetype end = path.lastIndexOf(kInRecording);
  return end < 0 ? path : path.mid(end + kInRecording.size());
}

QString FullName(const QString& path) {
  if (RecordingOf(path).isEmpty()) return path;
  return RecordingName(path) + QStringLiteral(" · ") + SignalOf(path);
}

QString ShortName(const QString& path) {
  const QStringList parts = SourceOf(SignalOf(path)).split('/');
  if (parts.size() < 3) return SignalOf(path);
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

void SetPaths(QMimeData& data, const QList<CurveKey>& keys) {
  data.setData(kPathMimeType, EncodedPaths(keys));
  if (!IsMomentShown()) return;
  const QByteArray moment = QByteArray::number(qlonglong{ShownWallTime()});
  data.setData(kRecordingMimeType, moment + '\n' + ShownRecording().toUtf8());
}

std::optional<std::int64_t> RecordedMomentIn(const QMimeData& data) {
  const auto from = OtherRecordingIn(data);
  return from ? std::optional(from->moment_ns) : std::nullopt;
}

QList<CurveKey> PathsIn(const QMimeData& data) {
  const auto from = OtherRecordingIn(data);
  QList<CurveKey> keys;
  const QString text = QString::fromUtf8(data.data(kPathMimeType));
  for (const QString& line : text.split('\n', Qt::SkipEmptyParts)) {
    CurveKey key{.path = line.section('\t', 0, 0).trimmed(),
                 .unit = line.section('\t', 1, 1).trimmed()};
    if (key.path.isEmpty()) continue;
    if (from) key.path = RecordedPath(from->recording, SignalOf(key.path));
    keys << key;
  }
  return keys;
}

}  // namespace tendon::gui
