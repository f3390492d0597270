#include <gcm_gui/plot/plot_page.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QEvent>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace tendon::gui {
namespace {

constexpr auto kCloseName = "closePlot";

// Places the close button above the right end of the canvas, where no unit is shown.
void PlaceClose(PlotView& view) {
  auto* close = view.findChild<QToolButton*>(kCloseName);
  const QRect canvas = view.canvas()->geometry();
  close->setGeometry(canvas.right() - PlotAxes::kTop, 0, PlotAxes::kTop, PlotAxes::kTop);
}

}  // namespace

PlotPage::PlotPage(QWidget* parent)
    : QWidget(parent),
      time_axis_(std::make_shared<SharedTimeAxis>()),
      rows_(new QSplitter(Qt::Vertical, this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(rows_);
  rows_->setChildrenCollapsible(false);
  rows_->setHandleWidth(kGrid);
  current_ = &insert(0);
  markCurrent();
}

PlotView& PlotPage::insert(int place) {
  auto* view = new PlotView(time_axis_, rows_);
  rows_->insertWidget(place, view);
  rows_->setStretchFactor(place, 1);
  views_.insert(views_.begin() + place, view);
  updatePlotsAbove();
  auto* close = new QToolButton(view);
  close->setObjectName(kCloseName);
  close->setAccessibleName(Words::tr("Close this plot"));
  close->setToolTip(Words::tr("Close this plot"));
  close->setIcon(ThemeIcon("close"));
  close->setIconSize({PlotAxes::kTop - kGrid, PlotAxes::kTop - kGrid});
  close->setFocusPolicy(Qt::TabFocus);
  SetRole(*close, "dim");
  // No padding, so that the button fits into the strip above the canvas.
  close->setStyleSheet("QToolButton { padding: 0; }");
  connect(close, &QToolButton::clicked, this, [this, view] { Q_EMIT closeRequested(view); });
  view->canvas()->installEventFilter(this);
  connect(view, &PlotView::sideRoomChanged, this, &PlotPage::align);
  return *view;
}

PlotView& PlotPage::split() {
  const int place = rows_->indexOf(current_) + 1;
  PlotView& view = insert(place);
  QList<int> heights;
  for (std::size_t i = 0; i < views_.size(); ++i) heights << std::max(1, height());
  rows_->setSizes(heights);  // only the ratios count, so all plots get the same height
  setCurrent(view);
  align();
  return view;
}

void PlotPage::close(PlotView& view) {
  const auto found = std::find(views_.begin(), views_.end(), &view);
  if (found == views_.end() || views_.size() == 1) return;
  const auto next = views_.erase(found);
  updatePlotsAbove();
  if (current_ == &view) current_ = next == views_.end() ? views_.back() : *next;
  view.hide();
  view.setParent(nullptr);
  view.deleteLater();
  markCurrent();
  align();
  Q_EMIT currentChanged();
}

bool PlotPage::holds(const PlotView& view) const {
  return std::find(views_.begin(), views_.end(), &view) != views_.end();
}

void PlotPage::setCurrent(PlotView& view) {
  if (current_ == &view) return markCurrent();
  current_ = &view;
  markCurrent();
  Q_EMIT currentChanged();
}

void PlotPage::updatePlotsAbove() {
  for (auto view = views_.begin(); view != views_.end(); ++view) {
    (*view)->setPlotsAbove({views_.begin(), view});
  }
}

// Marks the current plot. If there is only one plot, it needs neither a mark nor a close button.
void PlotPage::markCurrent() {
  const bool are_several = views_.size() > 1;
  for (PlotView* view : views_) {
    view->setMarkedCurrent(are_several && view == current_);
    view->findChild<QToolButton*>(kCloseName)->setVisible(are_several);
    PlaceClose(*view);
  }
}

void PlotPage::align() {
  AxisMargins most;
  for (PlotView* view : views_) {
    const AxisMargins room = view->axes().wantedRoom();
    most.left = std::max(most.left, room.left);
    most.right = std::max(most.right, room.right);
  }
  for (PlotView* view : views_) view->axes().setRoom(views_.size() > 1 ? most : AxisMargins{});
}

bool PlotPage::eventFilter(QObject* watched, QEvent* event) {
  const bool is_chosen =
      event->type() == QEvent::MouseButtonPress || event->type() == QEvent::FocusIn;
  const bool is_placed = event->type() == QEvent::Resize || event->type() == QEvent::Move;
  if (is_chosen || is_placed) {
    for (PlotView* view : views_) {
      if (view->canvas() != watched) continue;
      if (is_placed) {
        PlaceClose(*view);
      } else {
        setCurrent(*view);
      }
      break;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace tendon::gui
