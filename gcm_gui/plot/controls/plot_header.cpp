#include <gcm_gui/plot/controls/plot_header.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/controls/memory_meter.h>
#include <gcm_gui/plot/controls/rate_badge.h>
#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QAction>
#include <QActionGroup>
#include <QLayout>
#include <QMenu>
#include <QTabBar>
#include <QToolButton>
#include <algorithm>

namespace tendon::gui {
namespace {

using std::chrono::hours;
using std::chrono::minutes;
using std::chrono::nanoseconds;
using std::chrono::seconds;

constexpr int kMinTabs = 120;  // room for one tab and the scroll buttons

// A tab bar that is not wider than its tabs; QTabBar itself always reserves room for scroll
// buttons.
class TabBar final : public QTabBar {
 public:
  using QTabBar::QTabBar;
  [[nodiscard]] QSize minimumSizeHint() const override {
    return {std::min(sizeHint().width(), kMinTabs), kHeadHeight};
  }
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
  if (count % 60 == 0) return Words::tr("%1 min").arg(count / 60);
  return QString("%1 s").arg(count);
}

PlotHeader::PlotHeader(QWidget* parent)
    : HeaderRow(parent),
      tabs_(new TabBar(this)),
      plus_(Button("newPlot", Words::tr("New plot"), this)),
      split_(Button("splitPlot",
                    Words::tr("Add a plot below with the same time axis  (Ctrl+Shift+T)"), this)),
      memory_(new MemoryMeter(this)),
      badge_(new RateBadge(this)),
      window_(Button("window", Words::tr("Time span of the plot"), this)),
      back_(Button("back", Words::tr("Back to the previous view  (Alt+Left)"), this)),
      forward_(Button("forward", Words::tr("Forward again  (Alt+Right)"), this)),
      cursors_(Button("cursors", Words::tr("Cursors A and B  (A, B; Delete)"), this)),
      csv_(Button("saveCsv", Words::tr("Save the visible samples as CSV  (Ctrl+E)"), this)),
      sweep_(Button(
          "sweep", Words::tr("Sweep: new samples overwrite the old curves from left to right  (S)"),
          this)),
      pause_(Button("pause", Words::tr("Pause the view"), this)) {
  tabs_->setObjectName("plotTabs");
  tabs_->setAccessibleName(Words::tr("Plots"));
  tabs_->setDrawBase(false);
  tabs_->setExpanding(false);
  tabs_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  plus_->setIcon(ThemeIcon("plus"));
  split_->setIcon(ThemeIcon("split"));
  back_->setIcon(ThemeIcon("back"));
  forward_->setIcon(ThemeIcon("forward"));
  sweep_->setCheckable(true);
  setSweeping(false);
  setWay(false, false);
  pause_->setIcon(ThemeIcon("pause"));
  pause_->setCheckable(true);
  cursors_->setText("A/B");
  cursors_->setCheckable(true);
  csv_->setText("CSV");
  buildWindowMenu();
  addLeft(tabs_);
  addLeft(plus_);
  addLeft(split_);
  addRight(memory_);
  addRight(badge_);
  addRight(window_);
  addRight(back_);
  addRight(forward_);
  addRight(cursors_);
  addRight(csv_);
  addRight(sweep_);
  addRight(pause_);
  layout()->setSpacing(kGrid);
  connect(plus_, &QToolButton::clicked, this, &PlotHeader::newPlotRequested);
  connect(split_, &QToolButton::clicked, this, &PlotHeader::splitRequested);
  connect(back_, &QToolButton::clicked, this, &PlotHeader::backRequested);
  connect(forward_, &QToolButton::clicked, this, &PlotHeader::forwardRequested);
  connect(sweep_, &QToolButton::clicked, this, &PlotHeader::sweepToggled);
  connect(pause_, &QToolButton::clicked, this, &PlotHeader::pauseToggled);
  connect(cursors_, &QToolButton::clicked, this, &PlotHeader::cursorsToggled);
  connect(csv_, &QToolButton::clicked, this, &PlotHeader::csvRequested);
}

void PlotHeader::resizeEvent(QResizeEvent* event) {
  HeaderRow::resizeEvent(event);
  constexpr int kMedium = 520;
  constexpr int kWide = 600;
  constexpr int kVeryWide = 760;
  memory_->setVisible(width() >= kMedium);
  for (QToolButton* button : {split_, sweep_}) button->setVisible(width() >= kWide);
  for (QToolButton* button : {back_, forward_}) button->setVisible(width() >= kVeryWide);
}

void PlotHeader::buildWindowMenu() {
  auto* menu = new QMenu(window_);
  lengths_ = new QActionGroup(menu);
  for (const nanoseconds length :
       {nanoseconds(seconds(1)), nanoseconds(seconds(5)), nanoseconds(seconds(10)),
        nanoseconds(seconds(30)), nanoseconds(minutes(1)), nanoseconds(minutes(5)),
        nanoseconds(minutes(10)), nanoseconds(hours(1))}) {
    QAction* action = lengths_->addAction(menu->addAction(LengthText(length)));
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, length] { Q_EMIT windowChosen(length); });
  }
  // Does not use QToolButton's own menu: its handler blocks until the menu is closed.
  connect(window_, &QToolButton::clicked, menu,
          [this, menu] { menu->popup(window_->mapToGlobal(QPoint(0, window_->height()))); });
}

void PlotHeader::setMemory(std::size_t used, std::size_t budget, bool is_thinned) {
  memory_->setFigures(used, budget, is_thinned);
}

void PlotHeader::setFigures(const std::vector<SourceFigures>& figures) {
  badge_->setFigures(figures);
}

void PlotHeader::setWindow(nanoseconds length) {
  window_->setText(Words::tr("Last ") + LengthText(length));
  window_->setAccessibleName(Words::tr("Time span of the plot: ") + LengthText(length));
  for (QAction* action : lengths_->actions()) {
    action->setChecked(action->text() == LengthText(length));
  }
}

void PlotHeader::setCursors(bool shown) { cursors_->setChecked(shown); }

void PlotHeader::setSweeping(bool sweeping) {
  sweep_->setChecked(sweeping);
  sweep_->setIcon(ThemeIcon("sweep", sweeping ? Token::kAccent : Token::kDim));
}

void PlotHeader::setWay(bool has_former, bool has_later) {
  back_->setEnabled(has_former);
  forward_->setEnabled(has_later);
}

void PlotHeader::setPaused(bool paused) {
  pause_->setChecked(paused);
  pause_->setIcon(ThemeIcon(paused ? "play" : "pause", paused ? Token::kAccent : Token::kDim));
  pause_->setAccessibleName(paused ? Words::tr("Resume the view") : Words::tr("Pause the view"));
  pause_->setToolTip(paused ? Words::tr("Resume the view (Space)")
                            : Words::tr("Pause the view; new data is still received (Space)"));
}

}  // namespace tendon::gui
