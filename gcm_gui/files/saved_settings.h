#pragma once

#include <QByteArray>
#include <QHash>
#include <QString>

namespace tendon::gui {

/// Values that a program keeps from one run to the next, by name. The file is read once, at the
/// start. The FileWriter saves only the values that this program has set, so changes that another
/// program made to other values are kept. A failure is reported on stderr. GUI thread.
class SavedSettings {
 public:
  /// Reads the file. If this fails, all values are empty.
  explicit SavedSettings(const QString& file);

  /// Returns the value of this name; empty if there is none.
  [[nodiscard]] QByteArray value(const QString& name) const { return values_.value(name); }
  void set(const QString& name, const QByteArray& value);

 private:
  QString file_;
  QHash<QString, QByteArray> values_;
  QHash<QString, QByteArray> set_;  // the values set since the start
};

}  // namespace tendon::gui
