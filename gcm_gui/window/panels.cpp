#include <gcm_gui/window/panels.h>

#include <gcm_gui/language/words.h>

#include <QAction>
#include <QDataStream>
#include <QDockWidget>
#include <QIODevice>
#include <QLayout>
#include <QMainWindow>
#include <QMenu>
#include <QSplitter>
#include <QVBoxLayout>
#include <array>
#include <cstddef>

namespace tendon::gui {
namespace {

constexpr int kVersion = 1;  // version of saved layouts
// A panel must be closable so that the menu can hide it, even if no close button is visible.
constexpr QDockWidget::DockWidgetFeatures kFree =
    QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable;

/// The sizes of the panels in a perspective, in the order of add(); 0 if a panel is hidden. `plots`
/// is the fraction of the middle that the plots get.
struct PanelArrangement {
  const char* title;
  std::array<int, 3> sizes;
  double plots;
};
constexpr std::array<PanelArrangement, 4> kArrangements{
    {{QT_TRANSLATE_NOOP("Words", "Layout for connecting"), {280, 336, 124}, 0.40},
     {QT_TRANSLATE_NOOP("Words", "Layout for plotting"), {280, 0, 0}, 0.72},
     {QT_TRANSLATE_NOOP("Words", "Layout for operating"), {240, 420, 124}, 0.50},
     {QT_TRANSLATE_NOOP("Words", "Layout for diagnosing"), {280, 336, 260}, 0.30}}};

/// A panel that has the wanted size in the first layout.
class PanelPage final : public QWidget {
 public:
  PanelPage(QWidget* content, const QSize& wanted) : wanted_(wanted) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(content);
  }
  [[nodiscard]] QSize sizeHint() const override { return wanted_; }

 private:
  QSize wanted_;
};

}  // namespace

Panels::Panels(QMainWindow& window, QSplitter& centre)
    : QObject(&window), window_(window), centre_(centre) {
  window.setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  window.setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  window.setDockNestingEnabled(true);
}

Qt::Orientation Panels::across(Qt::DockWidgetArea area) {
  const bool side = area == Qt::LeftDockWidgetArea || area == Qt::RightDockWidgetArea;
  return side ? Qt::Horizontal : Qt::Vertical;
}

void Panels::add(QWidget* content, const QString& title, Qt::DockWidgetArea area, int size,
                 int least) {
  auto* dock = new QDockWidget(title, &window_);
  dock->setObjectName(QStringLiteral("dock.") + title);
  const bool side = across(area) == Qt::Horizontal;
  auto* page = new PanelPage(content, side ? QSize(size, 200) : QSize(400, size));
  side ? page->setMinimumWidth(least) : page->setMinimumHeight(least);
  dock->setWidget(page);
  window_.addDockWidget(area, dock);
  panels_.push_back({dock, area});
  setMovable(false);
}

void Panels::fill(QMenu& menu) {
  for (std::size_t i = 0; i < kArrangements.size(); ++i) {
    QAction* action = menu.addAction(Words::tr(kArrangements[i].title), this,
                                     [this, i] { show(static_cast<Perspective>(i)); });
    action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + i)));
    window_.addAction(action);  // so that the key works while the menu is closed
  }
  menu.addSeparator();
  for (const Panel& panel : panels_) menu.addAction(panel.dock->toggleViewAction());
  menu.addSeparator();
  movable_ = menu.addAction(Words::tr("Panels can be moved"));
  movable_->setCheckable(true);
  connect(movable_, &QAction::toggled, this, &Panels::setMovable);
  menu.addAction(Words::tr("Reset layout"), this, &Panels::reset);
}

void Panels::setMovable(bool movable) {
  for (const Panel& panel : panels_) {
    QWidget* title = panel.dock->titleBarWidget();
    // A panel that cannot be moved has an empty title bar, because its content has a header of its
    // own.
    panel.dock->setTitleBarWidget(movable ? nullptr : new QWidget(panel.dock));
    delete title;
    panel.dock->setFeatures(movable ? kFree : QDockWidget::DockWidgetClosable);
  }
  if (movable_ != nullptr) movable_->setChecked(movable);
}

void Panels::reveal(const QWidget& content) {
  for (const Panel& panel : panels_) {
    if (panel.dock->isAncestorOf(&content)) panel.dock->show();
  }
}

void Panels::ensureSize(const QWidget& content, int size) {
  for (const Panel& panel : panels_) {
    if (!panel.dock->isAncestorOf(&content)) continue;
    const Qt::Orientation along = across(panel.area);
    const int now = along == Qt::Vertical ? panel.dock->height() : panel.dock->width();
    if (now < size) window_.resizeDocks({panel.dock}, {size}, along);
  }
}

void Panels::show(Perspective perspective) {
  const PanelArrangement& wanted = kArrangements[static_cast<std::size_t>(perspective)];
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    panels_[i].dock->setVisible(wanted.sizes.at(i) > 0);
  }
  window_.layout()->activate();  // so that the sizes apply to the panels that are visible now
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    QDockWidget* dock = panels_[i].dock;
    const int size = wanted.sizes.at(i);
    if (size > 0) window_.resizeDocks({dock}, {size}, across(window_.dockWidgetArea(dock)));
  }
  window_.layout()->activate();
  const int height = centre_.height();
  const int plots = static_cast<int>(height * wanted.plots);
  centre_.setSizes({height - plots, plots});
  Q_EMIT shown(perspective);
}

void Panels::reset() {
  setMovable(false);
  for (const Panel& panel : panels_) window_.addDockWidget(panel.area, panel.dock);
  show(Perspective::kConnect);
  Q_EMIT wasReset();
}

QByteArray Panels::state() const {
  QByteArray state;
  QDataStream stream(&state, QIODevice::WriteOnly);
  stream << window_.saveState(kVersion) << centre_.saveState();
  return state;
}

void Panels::restore(const QByteArray& state) {
  QByteArray docks;
  QByteArray centre;
  QDataStream stream(state);
  stream >> docks >> centre;
  if (stream.status() != QDataStream::Ok) return;
  if (window_.restoreState(docks, kVersion)) centre_.restoreState(centre);
}

}  // namespace tendon::gui
