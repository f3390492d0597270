#pragma once

#include <QProxyStyle>

class QAbstractScrollArea;

namespace tendon::gui {

/// What palette and style sheet cannot say: the height of rows, the arrows of trees, how wide
/// splitters are, that labels and tool tips show text as it is, unless they ask for another format,
/// and that a wheel over a spin box or a choice that has no focus scrolls what it is in. Item views
/// are drawn here and not by the style sheet, which would slow them.
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

/// It has the focus, and it came there by a key: then it has to be shown where it is.
[[nodiscard]] bool HasKeyboardFocus(const QWidget& widget);

/// Frames `place` of the viewport while the area has the keyboard focus. To be called when the rest
/// is painted.
void PaintFocus(const QAbstractScrollArea& area, const QRect& place);

}  // namespace tendon::gui
