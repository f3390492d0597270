#include <gcm_gui/graph/zoom_buttons.h>

#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>

namespace tendon::gui {
namespace {

QToolButton* MakeButton(const QString& name, const QString& help) {
  auto* button = new QToolButton;
  button->setObjectName(name);
  button->setAccessibleName(help);
  button->setToolTip(help);
  button->setFocusPolicy(Qt::NoFocus);
  button->setFixedSize(kRowHeight, kRowHeight);
  SetRole(*button, QStringLiteral("dim"));
  return button;
}

}  // namespace

ZoomButtons::ZoomButtons(GraphView& graph) : QWidget(&graph) {
  setAutoFillBackground(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  QToolButton* out = MakeButton(QStringLiteral("zoomOut"), Words::tr("Smaller  (−)"));
  out->setText(QStringLiteral("−"));
  QToolButton* in = MakeButton(QStringLiteral("zoomIn"), Words::tr("Larger  (+)"));
  in->setText(QStringLiteral("+"));
  QToolButton* fit = MakeButton(QStringLiteral("fit"), Words::tr("Show all  (0)"));
  fit->setIcon(ThemeIcon(QStringLiteral("fit")));
  connect(out, &QToolButton::clicked, &graph, &GraphView::zoomOut);
  connect(in, &QToolButton::clicked, &graph, &GraphView::zoomIn);
  connect(fit, &QToolButton::clicked, &graph, &GraphView::fit);
  for (QToolButton* button : {out, in, fit}) row->addWidget(button);
  graph.installEventFilter(this);
  moveToCorner();
}

bool ZoomButtons::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) moveToCorner();
  return QWidget::eventFilter(watched, event);
}

void ZoomButtons::moveToCorner() {
  adjustSize();
  const QRect room = parentWidget()->rect();
  move(room.right() - width() - 2 * kGrid, room.bottom() - height() - 2 * kGrid);
}

}  // namespace tendon::gui
