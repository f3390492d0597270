#include <gcm_gui/activity/log_filter.h>

#include <gcm_gui/models/text.h>

#include <algorithm>

namespace tendon::gui {
namespace {

bool Has(const QString& source, const QString& text, const QString& word) {
  const QString from = QStringLiteral("from:");
  if (word.startsWith(from)) return source.contains(word.mid(from.size()), Qt::CaseInsensitive);
  return source.contains(word, Qt::CaseInsensitive) || text.contains(word, Qt::CaseInsensitive);
}

}  // namespace

bool HasWords(const QString& source, const QString& text, const QStringList& words) {
  return std::all_of(words.begin(), words.end(), [&](const QString& word) {
    const bool is_unwanted = word.size() > 1 && word.startsWith('-');
    return is_unwanted ? !Has(source, text, word.mid(1)) : Has(source, text, word);
  });
}

LogFilter::LogFilter(LogModel& model, QObject* parent)
    : QSortFilterProxyModel(parent), model_(model) {
  setSourceModel(&model);
}

void LogFilter::setLevel(LogLevel level) {
  level_ = level;
  invalidateFilter();
}

void LogFilter::setText(const QString& text) {
  words_ = text.split(' ', Qt::SkipEmptyParts);
  invalidateFilter();
}

bool LogFilter::filterAcceptsRow(int row, const QModelIndex&) const {
  const message::LogRecord& record = model_.record(row);
  if (record.level < level_) return false;
  return words_.isEmpty() || HasWords(SourceOf(record), ToQString(record.text), words_);
}

}  // namespace tendon::gui
