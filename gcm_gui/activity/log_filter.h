#pragma once

#include <gcm_gui/activity/log_model.h>

#include <QSortFilterProxyModel>
#include <QStringList>

namespace tendon::gui {

/// Shows the log records of at least a chosen level whose source or text contains every word of a
/// filter, ignoring case. `from:robot/arm` searches only the source. A word with a leading `-` must
/// not occur.
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

/// Returns true if a record with this source and text matches all these words.
[[nodiscard]] bool HasWords(const QString& source, const QString& text, const QStringList& words);

}  // namespace tendon::gui
