#include <gcm_gui/graph/layout_animation.h>

#include <QCoreApplication>
#include <QEasingCurve>

namespace tendon::gui {
namespace {

constexpr int kGlideTime = 150;  // ms

QRectF Between(const QRectF& from, const QRectF& to, double part) {
  const auto value = [part](double a, double b) { return a + (b - a) * part; };
  return {value(from.x(), to.x()), value(from.y(), to.y()), value(from.width(), to.width()),
          value(from.height(), to.height())};
}

/// Returns the rectangles of `to`. An item that is also in `from` is on its way: it has covered the
/// fraction `part` of the distance.
QHash<QString, QRectF> AllBetween(const QHash<QString, QRectF>& from, QHash<QString, QRectF> to,
                                  double part) {
  for (auto it = to.begin(); it != to.end(); ++it) {
    const auto before = from.constFind(it.key());
    if (before != from.constEnd()) *it = Between(*before, *it, part);
  }
  return to;
}

}  // namespace

LayoutAnimation::LayoutAnimation(QObject* parent) : QObject(parent) {
  way_.setDuration(kGlideTime);
  way_.setStartValue(0.0);
  way_.setEndValue(1.0);
  way_.setEasingCurve(QEasingCurve::OutCubic);
  connect(&way_, &QVariantAnimation::valueChanged, this, [this](const QVariant& part) {
    if (isOver()) return;
    show(part.toDouble());
    Q_EMIT moved();
  });
  connect(&way_, &QVariantAnimation::finished, this, [this] {
    now_ = to_;
    Q_EMIT moved();
  });
}

void LayoutAnimation::goTo(const Arrangement& arrangement) {
  const bool still = QCoreApplication::instance()->property(kStill).toBool();
  if (still || now_.nodes.isEmpty()) return jumpTo(arrangement);
  from_ = now_;
  to_ = arrangement;
  way_.stop();
  show(0);
  way_.start();
}

void LayoutAnimation::jumpTo(const Arrangement& arrangement) {
  way_.stop();
  to_ = arrangement;
  now_ = arrangement;
}

void LayoutAnimation::show(double part) {
  now_.boxes = AllBetween(from_.boxes, to_.boxes, part);
  now_.nodes = AllBetween(from_.nodes, to_.nodes, part);
}

}  // namespace tendon::gui
