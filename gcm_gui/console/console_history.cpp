#include <gcm_gui/console/console_history.h>

#include <gcm_gui/files/file_writer.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>

namespace tendon::gui {

ConsoleHistory::ConsoleHistory(const QString& file) : file_(file) {
  if (file_.isEmpty()) return;
  QDir().mkpath(QFileInfo(file_).path());
  QFile kept(file_);
  if (!kept.open(QIODevice::ReadOnly)) return;
  lines_ = QString::fromUtf8(kept.readAll()).split('\n', Qt::SkipEmptyParts);
  place_ = lines_.size();
}

void ConsoleHistory::add(const QString& line) {
  if (!line.trimmed().isEmpty() && (lines_.isEmpty() || lines_.last() != line)) {
    lines_.append(line);
    if (lines_.size() > kKept) lines_.removeFirst();
    keep();
  }
  place_ = lines_.size();
  typed_.clear();
}

QString ConsoleHistory::older(const QString& typed) {
  if (lines_.isEmpty()) return typed;
  if (place_ == lines_.size()) typed_ = typed;
  place_ = std::max<qsizetype>(place_ - 1, 0);
  return lines_[place_];
}

QString ConsoleHistory::newer() {
  place_ = std::min(place_ + 1, lines_.size());
  return place_ == lines_.size() ? typed_ : lines_[place_];
}

qsizetype ConsoleHistory::find(const QString& part, qsizetype before) const {
  for (qsizetype place = std::min(before, lines_.size() - 1); place >= 0; --place) {
    if (lines_[place].contains(part, Qt::CaseInsensitive)) return place;
  }
  return -1;
}

/// Saves the lines. A repeated failure is reported only once, so that it does not disturb the user.
void ConsoleHistory::keep() {
  if (file_.isEmpty()) return;
  const auto report = [this](const QString& refusal) {
    const bool is_new = !refusal.isEmpty() && !is_refusal_reported_;
    is_refusal_reported_ = !refusal.isEmpty();
    if (is_new) Q_EMIT notice(NotSaved(file_, refusal));
  };
  FileWriter::instance().write(file_, lines_.join('\n').toUtf8() + '\n', this, report,
                               FileWriter::Readers::kOwner);
}

}  // namespace tendon::gui
