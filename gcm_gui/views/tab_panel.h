#pragma once

#include <QList>
#include <QWidget>

class QStackedWidget;
class QTabBar;

namespace tendon::gui {

class HeaderRow;

/// Pages with a row of tabs. Tools can be added at the right of the tabs.
class TabPanel : public QWidget {
  Q_OBJECT

 public:
  explicit TabPanel(const QString& name, QWidget* parent = nullptr);

  /// Adds a page, and takes ownership. Returns the index of the page.
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
