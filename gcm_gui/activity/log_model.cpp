#include <gcm_gui/activity/log_model.h>

#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/models/text.h>

#include <algorithm>

namespace tendon::gui {
namespace {

/// Returns the mark of a record. Only warnings and errors have one.
QVariant LevelMark(LogLevel level) {
  if (level == LogLevel::kError) return QVariant::fromValue(StateMark::kFaulted);
  if (level == LogLevel::kWarning) return QVariant::fromValue(StateMark::kWarning);
  return {};
}

}  // namespace

QString SourceOf(const message::LogRecord& record) {
  if (record.source.empty() || record.source == record.process) return ToQString(record.process);
  return ToQString(record.process + '/' + record.source);
}

int LogModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(records_.size());
}

QVariant LogModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const message::LogRecord& record = this->record(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return ToQString(record.text);
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
      return QStringLiteral("%1 %2: %3")
          .arg(ToQString(ToString(record.level)), SourceOf(record), ToQString(record.text));
    case kTimeRole:
      return ClockText(record.time);
    case kGlyphMarkRole:
      return LevelMark(record.level);
    case kGlyphRole:
      return QStringLiteral(" ");
    case kStaleRole:  // dimmed, because it matters only for debugging
      return record.level == LogLevel::kDebug;
    case kTrailRole:
    case kPathRole:
      return SourceOf(record);
    case kLevelRole:
      return static_cast<int>(record.level);
    default:
      return {};
  }
}

void LogModel::add(const LogBatch& batch) {
  lost_ += batch.lost;
  const std::size_t all = batch.records.size();
  const std::size_t fresh = std::min(all, kKept);
  lost_ += all - fresh;
  if (fresh == 0) return;
  const std::size_t kept = records_.size();
  if (kept + fresh > kKept) {
    const std::size_t gone = kept + fresh - kKept;
    beginRemoveRows({}, 0, static_cast<int>(gone) - 1);
    records_.erase(records_.begin(), records_.begin() + static_cast<std::ptrdiff_t>(gone));
    endRemoveRows();
  }
  const int first = rowCount();
  beginInsertRows({}, first, first + static_cast<int>(fresh) - 1);
  records_.insert(records_.end(), batch.records.end() - static_cast<std::ptrdiff_t>(fresh),
                  batch.records.end());
  endInsertRows();
}

void LogModel::clear() {
  beginResetModel();
  records_.clear();
  endResetModel();
}

}  // namespace tendon::gui
