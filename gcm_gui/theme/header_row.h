#pragma once

#include <QFrame>

class QHBoxLayout;
class QLabel;

namespace tendon::gui {

/// The header of a panel: 32 pixels high, with a line below it, the title on the left and tools on
/// the right.
class HeaderRow : public QFrame {
  Q_OBJECT

 public:
  explicit HeaderRow(QWidget* parent = nullptr);
  /// Creates a header with a title in the strong font.
  explicit HeaderRow(const QString& title, QWidget* parent = nullptr);

  void setTitle(const QString& title);
  /// Adds a widget on the left, after the title. Takes ownership.
  void addLeft(QWidget* widget);
  /// Adds a widget on the right. Takes ownership.
  void addRight(QWidget* widget);

 private:
  QHBoxLayout* row_;
  QLabel* title_ = nullptr;
  int left_count_ = 0;
};

}  // namespace tendon::gui
