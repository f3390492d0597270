#include <gcm_gui/theme/tendon_style.h>

#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QPolygonF>
#include <QStyleOption>
#include <algorithm>

namespace tendon::gui {
namespace {

// Draws the arrows ▸ and ▾ as shapes, because not every font contains these characters.
void DrawBranchArrow(const QStyleOption& option, QPainter& painter) {
  if (!option.state.testFlag(QStyle::State_Children)) return;
  constexpr double kHalf = 4;
  const QPointF centre = QRectF(option.rect).center();
  QPolygonF arrow({{-kHalf / 2, -kHalf}, {kHalf / 2 + 0.5, 0}, {-kHalf / 2, kHalf}});
  if (option.state.testFlag(QStyle::State_Open)) {
    arrow = QPolygonF({{-kHalf, -kHalf / 2}, {kHalf, -kHalf / 2}, {0, kHalf / 2 + 0.5}});
  }
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(Theme::instance().color(Token::kDim));
  painter.drawPolygon(arrow.translated(centre));
  painter.restore();
}

void DrawFocus(const QStyleOption& option, QPainter& painter) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Theme::instance().color(Token::kAccent));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), kGrid, kGrid);
  painter.restore();
}

}  // namespace

TendonStyle::TendonStyle() : QProxyStyle("Fusion") {}

void TendonStyle::polish(QWidget* widget) {
  QProxyStyle::polish(widget);
  if (auto* view = qobject_cast<QAbstractItemView*>(widget)) view->setFrameShape(QFrame::NoFrame);
  // Names and descriptions of processes may contain markup, so labels show plain text. A tool tip
  // is a label, too.
  auto* const label = qobject_cast<QLabel*>(widget);
  const bool guesses = label != nullptr && label->textFormat() == Qt::AutoText;
  if (guesses) label->setTextFormat(Qt::PlainText);
  if (qobject_cast<QAbstractSpinBox*>(widget) != nullptr ||
      qobject_cast<QComboBox*>(widget) != nullptr) {
    if (widget->focusPolicy() == Qt::WheelFocus) widget->setFocusPolicy(Qt::StrongFocus);
    // Installed only once, even if a widget is polished several times.
    widget->installEventFilter(this);
  }
}

// Ignores a wheel event for a widget without the focus; Qt then passes the event to the parent.
bool TendonStyle::eventFilter(QObject* watched, QEvent* event) {
  const auto* const widget = qobject_cast<QWidget*>(watched);
  const bool passes = event->type() == QEvent::Wheel && widget != nullptr && !widget->hasFocus();
  if (!passes) return QProxyStyle::eventFilter(watched, event);
  event->ignore();
  return true;
}

int TendonStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                             const QWidget* widget) const {
  switch (metric) {
    case PM_SplitterWidth:
    case PM_DockWidgetSeparatorExtent:
      return kGap;
    case PM_TreeViewIndentation:
      return kIndent;
    case PM_ScrollBarExtent:
      return 10;
    case PM_SmallIconSize:
    case PM_ButtonIconSize:
    case PM_TabBarIconSize:
      return 16;
    case PM_TabBarTabShiftHorizontal:
    case PM_TabBarTabShiftVertical:
    case PM_ButtonShiftHorizontal:
    case PM_ButtonShiftVertical:
      return 0;
    default:
      return QProxyStyle::pixelMetric(metric, option, widget);
  }
}

int TendonStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                           QStyleHintReturn* result) const {
  switch (hint) {
    case SH_EtchDisabledText:
    case SH_UnderlineShortcut:
    case SH_ItemView_ActivateItemOnSingleClick:
    case SH_ItemView_ArrowKeysNavigateIntoChildren:
      return hint == SH_ItemView_ArrowKeysNavigateIntoChildren ? 1 : 0;
    case SH_ToolTip_WakeUpDelay:
      return 400;
    default:
      return QProxyStyle::styleHint(hint, option, widget, result);
  }
}

QSize TendonStyle::sizeFromContents(ContentsType type, const QStyleOption* option,
                                    const QSize& size, const QWidget* widget) const {
  QSize result = QProxyStyle::sizeFromContents(type, option, size, widget);
  if (type == CT_ItemViewItem) result.setHeight(std::max(result.height(), kRowHeight));
  return result;
}

void TendonStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                QPainter* painter, const QWidget* widget) const {
  switch (element) {
    case PE_IndicatorBranch:
      return DrawBranchArrow(*option, *painter);
    case PE_FrameFocusRect:
      // Draws no frame in item views, because they draw the frame around whole rows themselves.
      // Draws no frame either if the user works with the mouse.
      if (option->state.testFlag(State_KeyboardFocusChange) &&
          qobject_cast<const QAbstractItemView*>(widget) == nullptr) {
        DrawFocus(*option, *painter);
      }
      return;
    default:
      return QProxyStyle::drawPrimitive(element, option, painter, widget);
  }
}

bool HasKeyboardFocus(const QWidget& widget) {
  return widget.hasFocus() && widget.window()->testAttribute(Qt::WA_KeyboardFocusChange);
}

void PaintFocus(const QAbstractScrollArea& area, const QRect& place) {
  if (!HasKeyboardFocus(area)) return;
  QStyleOption option;
  option.rect = place;
  QPainter painter(area.viewport());
  DrawFocus(option, painter);
}

}  // namespace tendon::gui
