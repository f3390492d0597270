#include <gcm_gui/plot/controls/legend_area.h>

#include <gcm_gui/plot/canvas/plot_axes.h>
#include <gcm_gui/theme/metrics.h>
#include <qwt_plot.h>

#include <QEvent>
#include <QScrollBar>
#include <algorithm>

namespace tendon::gui {
namespace {

constexpr int kOneRow = 18;
// The minimum height of canvas and axis together. In a low plot, the legend is lower instead.
constexpr int kMinPlot = 110;
constexpr double kHighest = 0.4;  // fraction of the plot
constexpr int kEdge = kInset;

}  // namespace

LegendArea::LegendArea(QwtPlot& plot)
    : QScrollArea(&plot), plot_(plot), legend_(new Legend(nullptr)) {
  setObjectName("legendArea");
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  viewport()->setAutoFillBackground(false);
  setWidget(legend_);
  legend_->setAutoFillBackground(false);
  legend_->installEventFilter(this);
  place();
}

bool LegendArea::eventFilter(QObject* watched, QEvent* event) {
  const bool is_other = event->type() == QEvent::Resize || event->type() == QEvent::ShowToParent ||
                        event->type() == QEvent::HideToParent;
  if (watched == legend_ && is_other) place();
  return QScrollArea::eventFilter(watched, event);
}

void LegendArea::place() {
  setVisible(!legend_->isHidden());
  const int width = plot_.width() - 2 * kEdge;
  legend_->setRoom(width - verticalScrollBar()->sizeHint().width());
  const int share = static_cast<int>(kHighest * plot_.height());
  const int most = std::min(share, std::max(kOneRow, plot_.height() - kMinPlot));
  const int height = legend_->isHidden() ? 0 : std::min(legend_->height(), most);
  const QMargins sides = plot_.contentsMargins();
  plot_.setContentsMargins(sides.left(), PlotAxes::kTop, sides.right(), height + 2 * kGrid);
  setGeometry(kEdge, plot_.height() - height - kGrid, width, height);
}

}  // namespace tendon::gui
