#pragma once

#include <QFrame>

class QHBoxLayout;
class QLabel;

namespace tendon::gui {

/// The head of a panel: 32 pixels high, with a line below it, the title on the left and tools on
/// the right.
class HeaderRow : public QFrame {
  Q_OBJECT

 public:
  explicit HeaderRow(QWidget* parent = nullptr);
  /// With a title in the strong font.
  explicit HeaderRow(const QString& title, QWidget* parent = nullptr);

  void setTitle(const QString& title);
  /// Appends on the left, after the title; takes ownership.
  void addLeft(QWidget* widget);
  /// Appends on the right; takes ownership.
  void addRight(QWidget* widget);

 private:
  QHBoxLayout* row_;
  QLabel* title_ = nullptr;
  int left_count_ = 0;
};

}  // namespace tendon::gui
