#include <gcm_gui/theme/state_mark.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/theme.h>

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <array>
#include <cstddef>

namespace tendon::gui {
namespace {

enum class Shape { kDisc, kRing, kDashedRing, kHalfDisc, kSquare, kBars, kTriangle, kCross };

struct Look {
  const char* word;
  Shape shape;
  Token color;
};

// One entry for each StateMark, in the same order.
constexpr std::array<Look, kStateMarkCount> kLooks{{
    {QT_TRANSLATE_NOOP("Words", "constructed"), Shape::kRing, Token::kDim},
    {QT_TRANSLATE_NOOP("Words", "ready"), Shape::kHalfDisc, Token::kDim},
    {QT_TRANSLATE_NOOP("Words", "active"), Shape::kDisc, Token::kOk},
    {QT_TRANSLATE_NOOP("Words", "suspended"), Shape::kBars, Token::kWarning},
    {QT_TRANSLATE_NOOP("Words", "finished"), Shape::kSquare, Token::kDim},
    {QT_TRANSLATE_NOOP("Words", "faulted"), Shape::kCross, Token::kBad},
    {QT_TRANSLATE_NOOP("Words", "connected"), Shape::kDisc, Token::kAccent},
    {QT_TRANSLATE_NOOP("Words", "pending"), Shape::kDashedRing, Token::kAccent},
    {QT_TRANSLATE_NOOP("Words", "not connected"), Shape::kRing, Token::kAccent},
    {QT_TRANSLATE_NOOP("Words", "refused"), Shape::kCross, Token::kBad},
    {QT_TRANSLATE_NOOP("Words", "warning"), Shape::kTriangle, Token::kWarning},
    {QT_TRANSLATE_NOOP("Words", "lost"), Shape::kCross, Token::kBad},
}};

const Look& LookOf(StateMark mark) { return kLooks.at(static_cast<std::size_t>(mark)); }

// Paints the shape in the square from -1 to 1.
void PaintShape(QPainter& painter, Shape shape, const QColor& color) {
  QPen pen(color, 0.42);
  pen.setCapStyle(Qt::RoundCap);
  const bool outlined =
      shape == Shape::kRing || shape == Shape::kDashedRing || shape == Shape::kCross;
  if (shape == Shape::kDashedRing) pen.setDashPattern({1.2, 1.8});
  painter.setPen(outlined || shape == Shape::kHalfDisc ? pen : QPen(Qt::NoPen));
  painter.setBrush(outlined ? QBrush(Qt::NoBrush) : QBrush(color));
  switch (shape) {
    case Shape::kDisc:
      return painter.drawEllipse(QPointF(), 1.0, 1.0);
    case Shape::kRing:
    case Shape::kDashedRing:
      return painter.drawEllipse(QPointF(), 0.85, 0.85);
    case Shape::kHalfDisc:
      painter.drawArc(QRectF(-0.85, -0.85, 1.7, 1.7), -90 * 16, 180 * 16);
      return painter.drawChord(QRectF(-0.85, -0.85, 1.7, 1.7), 90 * 16, 180 * 16);
    case Shape::kSquare:
      return painter.drawRect(QRectF(-0.85, -0.85, 1.7, 1.7));
    case Shape::kBars:
      painter.drawRect(QRectF(-0.9, -1, 0.65, 2));
      return painter.drawRect(QRectF(0.25, -1, 0.65, 2));
    case Shape::kTriangle:
      return painter.drawPolygon(QPolygonF({{0, -1.05}, {1.15, 0.95}, {-1.15, 0.95}}));
    case Shape::kCross:
      painter.drawLine(QPointF(-0.8, -0.8), QPointF(0.8, 0.8));
      return painter.drawLine(QPointF(-0.8, 0.8), QPointF(0.8, -0.8));
  }
}

}  // namespace

QString WordOf(StateMark mark) { return Words::tr(LookOf(mark).word); }

QString KeyOf(StateMark mark) { return QString::fromLatin1(LookOf(mark).word); }

Token ColorOf(StateMark mark) { return LookOf(mark).color; }

void PaintMark(QPainter& painter, const QRectF& rect, StateMark mark) {
  const Look& look = LookOf(mark);
  const double radius = std::min(rect.width(), rect.height()) * 0.27;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(rect.center());
  painter.scale(radius, radius);
  PaintShape(painter, look.shape, Theme::instance().color(look.color));
  painter.restore();
}

}  // namespace tendon::gui
