#pragma once

#include <gcm_gui/activity/log_model.h>

#include <QSortFilterProxyModel>
#include <QStringList>

namespace tendon::gui {

/// Shows the records of a level and above that contain every word of a filter in source or text,
/// ignoring case. `from:robot/arm` searches the source only; a word with `-` must not occur.
class LogFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit LogFilter(LogModel& model, QObject* parent = nullptr);

  void setLevel(LogLevel level);
  void setText(const QString& text);

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  LogModel& model_;
  LogLevel level_ = LogLevel::kDebug;
  QStringList words_;
};

/// True if a line of `source` and `text` matches all these words.
[[nodiscard]] bool HasWords(const QString& source, const QString& text, const QStringList& words);

}  // namespace tendon::gui
