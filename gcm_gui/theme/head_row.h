#pragma once

#include <QFrame>

class QHBoxLayout;
class QLabel;

namespace tendon::gui {

/// The head of a panel: 32 pixels high, a line below it, what it is at the left, what can be done
/// at the right.
class HeadRow : public QFrame {
  Q_OBJECT

 public:
  explicit HeadRow(QWidget* parent = nullptr);
  /// With a title in strong letters.
  explicit HeadRow(const QString& title, QWidget* parent = nullptr);

  void setTitle(const QString& title);
  /// From the left, behind the title; takes ownership.
  void addLeft(QWidget* widget);
  /// From the middle towards the right edge; takes ownership.
  void addRight(QWidget* widget);

 private:
  QHBoxLayout* row_;
  QLabel* title_ = nullptr;
  int left_count_ = 0;
};

}  // namespace tendon::gui
