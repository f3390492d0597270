#include <gcm_gui/views/tab_panel.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/theme/header_row.h>

#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

namespace tendon::gui {

TabPanel::TabPanel(const QString& name, QWidget* parent)
    : QWidget(parent),
      head_(new HeaderRow(this)),
      tabs_(new QTabBar),
      pages_(new QStackedWidget(this)) {
  setObjectName(name);
  setAutoFillBackground(true);
  tabs_->setObjectName(name + QStringLiteral(".tabs"));
  tabs_->setExpanding(false);
  tabs_->setDrawBase(false);
  tabs_->setUsesScrollButtons(false);
  tabs_->setElideMode(Qt::ElideNone);
  tabs_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
  head_->addLeft(tabs_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(head_);
  column->addWidget(pages_, 1);
  connect(tabs_, &QTabBar::currentChanged, pages_, &QStackedWidget::setCurrentIndex);
  connect(tabs_, &QTabBar::currentChanged, this, &TabPanel::currentChanged);
}

int TabPanel::addPage(QWidget* page, const QString& title) {
  pages_->addWidget(page);
  ExceptionGuard::setName(*page, title);
  return tabs_->addTab(title);
}

void TabPanel::setTitle(int page, const QString& title) { tabs_->setTabText(page, title); }

void TabPanel::setCurrent(int page) { tabs_->setCurrentIndex(page); }

int TabPanel::current() const { return tabs_->currentIndex(); }

void TabPanel::addRight(QWidget* widget) { head_->addRight(widget); }

}  // namespace tendon::gui
