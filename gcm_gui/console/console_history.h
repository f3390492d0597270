#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

namespace tendon::gui {

/// The lines that were typed, and a place among them: behind the newest, until one is gone back to.
/// Kept in a file, where there is one. GUI thread; the FileWriter writes the file.
class ConsoleHistory : public QObject {
  Q_OBJECT

 public:
  static constexpr int kKept = 1000;

  /// An empty file name keeps nothing.
  explicit ConsoleHistory(const QString& file = {});

  /// Empty lines, and the newest once more, are not added.
  void add(const QString& line);
  /// The one before, `typed` is what stands there now; the oldest again where there is none before.
  [[nodiscard]] QString older(const QString& typed);
  /// The one after; at last what was typed.
  [[nodiscard]] QString newer();
  /// The newest line with `part` in it, from place `before` down; -1 for none.
  [[nodiscard]] qsizetype find(const QString& part, qsizetype before) const;
  [[nodiscard]] const QStringList& lines() const { return lines_; }

 Q_SIGNALS:
  /// For the user, once: the lines could not be kept.
  void notice(const QString& text);

 private:
  void keep();

  QString file_;
  QStringList lines_;
  qsizetype place_ = 0;
  QString typed_;
  bool is_refusal_told_ = false;  // until it is written again
};

}  // namespace tendon::gui
