#pragma once

#include <QList>
#include <QWidget>

class QStackedWidget;
class QTabBar;

namespace tendon::gui {

class HeaderRow;

/// Pages with a row of tabs, and room for tools at the right of the tabs.
class TabPanel : public QWidget {
  Q_OBJECT

 public:
  explicit TabPanel(const QString& name, QWidget* parent = nullptr);

  /// Takes ownership. Returns the page's index.
  int addPage(QWidget* page, const QString& title);
  void setTitle(int page, const QString& title);
  void setCurrent(int page);
  [[nodiscard]] int current() const;
  /// Adds a tool at the right of the tabs; takes ownership.
  void addRight(QWidget* widget);
  [[nodiscard]] QTabBar& tabs() const { return *tabs_; }

 Q_SIGNALS:
  void currentChanged(int page);

 private:
  HeaderRow* head_;
  QTabBar* tabs_;
  QStackedWidget* pages_;
};

}  // namespace tendon::gui
