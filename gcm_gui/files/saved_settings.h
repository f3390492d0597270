#pragma once

#include <QByteArray>
#include <QHash>
#include <QString>

namespace tendon::gui {

/// Values that a program saves from one run to the next, by name. The file is read once, at the
/// start. The FileWriter saves the values that were set since then, and keeps changes by other
/// programs to the other values; a failure is reported on stderr. GUI thread.
class SavedSettings {
 public:
  /// If the file cannot be read, no earlier value is known.
  explicit SavedSettings(const QString& file);

  /// Empty if there is none.
  [[nodiscard]] QByteArray value(const QString& name) const { return values_.value(name); }
  void set(const QString& name, const QByteArray& value);

 private:
  QString file_;
  QHash<QString, QByteArray> values_;
  QHash<QString, QByteArray> set_;  // the values set since the start
};

}  // namespace tendon::gui
