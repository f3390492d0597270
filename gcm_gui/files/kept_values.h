#pragma once

#include <QByteArray>
#include <QHash>
#include <QString>

namespace tendon::gui {

/// What a program remembers from one time to the next, by name. Read once, at the beginning; the
/// FileWriter writes what was set since, and leaves the rest of the file as another program has
/// written it meanwhile. What it refuses is said on stderr. GUI thread.
class KeptValues {
 public:
  /// A file that cannot be read keeps nothing from before.
  explicit KeptValues(const QString& file);

  /// Empty where there is none.
  [[nodiscard]] QByteArray value(const QString& name) const { return values_.value(name); }
  void set(const QString& name, const QByteArray& value);

 private:
  QString file_;
  QHash<QString, QByteArray> values_;
  QHash<QString, QByteArray> set_;  // of those, since the beginning
};

}  // namespace tendon::gui
