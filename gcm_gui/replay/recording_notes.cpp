#include <gcm_gui/replay/recording_notes.h>

#include <QFileInfo>

namespace tendon::gui {
namespace {

QString NameOfRecent() { return QStringLiteral("recent"); }

QString MarksOf(const QString& file) { return QStringLiteral("marks of ") + file; }

QStringList Lines(const QByteArray& value) {
  return QString::fromUtf8(value).split('\n', Qt::SkipEmptyParts);
}

}  // namespace

RecordingNotes::RecordingNotes(const QString& folder) {
  if (!folder.isEmpty()) kept_.emplace(folder + QStringLiteral("/recordings.json"));
}

QStringList RecordingNotes::recent() const {
  QStringList files = kept_ ? Lines(kept_->value(NameOfRecent())) : QStringList();
  files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
  return files;
}

void RecordingNotes::addRecent(const QString& file) {
  if (!kept_) return;
  QStringList files = Lines(kept_->value(NameOfRecent()));
  files.removeAll(file);
  files.prepend(file);
  kept_->set(NameOfRecent(), files.mid(0, kMaxRecent).join('\n').toUtf8());
}

QList<std::int64_t> RecordingNotes::marks(const QString& file) const {
  QList<std::int64_t> marks;
  if (!kept_) return marks;
  for (const QString& line : Lines(kept_->value(MarksOf(file)))) {
    bool is_number = false;
    const qint64 mark = line.toLongLong(&is_number);
    if (is_number) marks << mark;
  }
  return marks;
}

void RecordingNotes::setMarks(const QString& file, const QList<std::int64_t>& marks) {
  if (!kept_) return;
  QStringList lines;
  for (const std::int64_t mark : marks) lines << QString::number(mark);
  kept_->set(MarksOf(file), lines.join('\n').toUtf8());
}

}  // namespace tendon::gui
