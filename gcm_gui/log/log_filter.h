#pragma once

#include <gcm_gui/log/log_model.h>

#include <QSortFilterProxyModel>
#include <QStringList>

namespace tendon::gui {

/// The records of a level and above in which every word of a filter is: in source or text, whatever
/// the case; `from:robot/arm` is in the source, and with a `-` before it a word is nowhere.
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

/// Whether a line of `source` and `text` has all these words.
[[nodiscard]] bool HasWords(const QString& source, const QString& text, const QStringList& words);

}  // namespace tendon::gui
