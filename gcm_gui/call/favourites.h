#pragma once

#include <QList>
#include <QObject>
#include <QString>

namespace tendon::gui {

/// A command with its argument, kept for later calls.
struct Favourite {
  QString path;      ///< "robot/arm/Control.MoveTo"
  QString argument;  ///< JSON; empty if the command has none

  bool operator==(const Favourite&) const = default;
};

/// The favourite commands by path, whether they exist now or not. Saved in a file if a name is
/// given.
class Favourites : public QObject {
  Q_OBJECT

 public:
  /// With an empty file name, nothing is saved.
  explicit Favourites(const QString& file, QObject* parent = nullptr);

  [[nodiscard]] const QList<Favourite>& all() const { return all_; }
  /// Does nothing if the list already contains this favourite.
  void add(const Favourite& favourite);
  void remove(const Favourite& favourite);

 Q_SIGNALS:
  void changed();
  /// Emitted with a sentence for the user if the file could not be written.
  void notice(const QString& text);

 private:
  void load();
  void keep();

  QString file_;
  QList<Favourite> all_;
};

}  // namespace tendon::gui
