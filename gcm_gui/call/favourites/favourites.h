#pragma once

#include <QList>
#include <QObject>
#include <QString>

namespace tendon::gui {

/// A command with its argument, at hand for the next time.
struct Favourite {
  QString path;      ///< "robot/arm/Control.MoveTo"
  QString argument;  ///< JSON; empty for none

  bool operator==(const Favourite&) const = default;
};

/// The commands an operator wants at hand, by path, whether they are there now or not. Kept in a
/// file, where there is one.
class Favourites : public QObject {
  Q_OBJECT

 public:
  /// An empty file name keeps nothing.
  explicit Favourites(const QString& file, QObject* parent = nullptr);

  [[nodiscard]] const QList<Favourite>& all() const { return all_; }
  /// The same once more changes nothing.
  void add(const Favourite& favourite);
  void remove(const Favourite& favourite);

 Q_SIGNALS:
  void changed();
  /// One sentence for the user, where they could not be kept.
  void notice(const QString& text);

 private:
  void load();
  void keep();

  QString file_;
  QList<Favourite> all_;
};

}  // namespace tendon::gui
