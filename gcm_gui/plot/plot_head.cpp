#include <gcm_gui/plot/plot_head.h>
#include <gcm_gui/plot/rate_badge.h>
#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QAction>
#include <QLayout>
#include <QMenu>
#include <QTabBar>
#include <QToolButton>

namespace tendon::gui {
namespace {

using std::chrono::hours;
using std::chrono::minutes;
using std::chrono::nanoseconds;
using std::chrono::seconds;

// As narrow as its tabs; the original keeps room for scroll buttons even when it has none.
class TabBar final : public QTabBar {
 public:
  using QTabBar::QTabBar;
  [[nodiscard]] QSize minimumSizeHint() const override { return {0, kHeadHeight}; }
};

QToolButton* Button(const QString& object, const QString& name, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName(object);
  button->setAccessibleName(name);
  button->setToolTip(name);
  button->setFocusPolicy(Qt::TabFocus);
  SetRole(*button, "dim");
  return button;
}

}  // namespace

QString LengthText(nanoseconds length) {
  const auto count = std::chrono::duration_cast<seconds>(length).count();
  if (count % 3600 == 0) return QString("%1 h").arg(count / 3600);
  if (count % 60 == 0) return QString("%1 min").arg(count / 60);
  return QString("%1 s").arg(count);
}

PlotHead::PlotHead(QWidget* parent)
    : HeadRow(parent),
      tabs_(new TabBar(this)),
      plus_(Button("newPlot", "New plot", this)),
      badge_(new RateBadge(this)),
      window_(Button("window", "Window length", this)),
      cursors_(Button("cursors", "Cursors A and B  (A, B; Delete)", this)),
      pause_(Button("pause", "Pause the view", this)) {
  tabs_->setObjectName("plotTabs");
  tabs_->setAccessibleName("Plots");
  tabs_->setDrawBase(false);
  tabs_->setExpanding(false);
  tabs_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  plus_->setIcon(ThemeIcon("plus"));
  pause_->setIcon(ThemeIcon("pause"));
  pause_->setCheckable(true);
  cursors_->setText("A/B");
  cursors_->setCheckable(true);
  buildWindowMenu();
  addLeft(tabs_);
  addLeft(plus_);
  addRight(badge_);
  addRight(window_);
  addRight(cursors_);
  addRight(pause_);
  layout()->setSpacing(kGrid);
  connect(plus_, &QToolButton::clicked, this, &PlotHead::newPlotRequested);
  connect(pause_, &QToolButton::clicked, this, &PlotHead::pauseToggled);
  connect(cursors_, &QToolButton::clicked, this, &PlotHead::cursorsToggled);
}

void PlotHead::buildWindowMenu() {
  auto* menu = new QMenu(window_);
  for (const nanoseconds length :
       {nanoseconds(seconds(1)), nanoseconds(seconds(5)), nanoseconds(seconds(10)),
        nanoseconds(seconds(30)), nanoseconds(minutes(1)), nanoseconds(minutes(5)),
        nanoseconds(minutes(10)), nanoseconds(hours(1))}) {
    menu->addAction(LengthText(length), this, [this, length] { Q_EMIT windowChosen(length); });
  }
  window_->setMenu(menu);
  window_->setPopupMode(QToolButton::InstantPopup);
}

void PlotHead::setFigures(const std::vector<SourceFigures>& figures) {
  badge_->setFigures(figures);
}

void PlotHead::setWindow(nanoseconds length) {
  window_->setText("window " + LengthText(length));
  window_->setAccessibleName("Window length: " + LengthText(length));
}

void PlotHead::setCursors(bool shown) { cursors_->setChecked(shown); }

void PlotHead::setPaused(bool paused) {
  pause_->setChecked(paused);
  pause_->setIcon(ThemeIcon(paused ? "play" : "pause", paused ? Token::kAccent : Token::kDim));
  pause_->setAccessibleName(paused ? "Resume the view" : "Pause the view");
  pause_->setToolTip(paused ? "Resume the view (Space)" : "Pause the view, not the data (Space)");
}

}  // namespace tendon::gui
