#pragma once

#include <QProxyStyle>

class QAbstractScrollArea;

namespace tendon::gui {

/// The parts of the look that neither palette nor style sheet can set: row heights, arrows of
/// trees, the width of splitters, and plain text in labels and tool tips that do not set another
/// format. If a spin box or choice does not have the focus, the mouse wheel scrolls the page
/// instead of changing its value. The style also draws item views, because a style sheet would make
/// them slow.
class TendonStyle : public QProxyStyle {
  Q_OBJECT

 public:
  TendonStyle();

  void polish(QWidget* widget) override;
  using QProxyStyle::polish;
  int pixelMetric(PixelMetric metric, const QStyleOption* option,
                  const QWidget* widget) const override;
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* result) const override;
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                         const QWidget* widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  bool eventFilter(QObject* watched, QEvent* event) override;
};

/// Returns true if the widget got the focus by a key. The focus must then be visible.
[[nodiscard]] bool HasKeyboardFocus(const QWidget& widget);

/// Draws a frame around `place` in the viewport while the area has the keyboard focus. Call it
/// after all other painting.
void PaintFocus(const QAbstractScrollArea& area, const QRect& place);

}  // namespace tendon::gui
