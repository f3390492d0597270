#include <gcm_gui/plot/controls/memory_meter.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/theme.h>

#include <QPainter>
#include <algorithm>

namespace tendon::gui {
namespace {

constexpr int kBarHeight = 4;  // pixels high
constexpr double kMega = 1e6;

}  // namespace

MemoryMeter::MemoryMeter(QWidget* parent) : QWidget(parent) {
  setObjectName("memory");
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  setFigures(0, 1, false);
  connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void MemoryMeter::setFigures(std::size_t used, std::size_t budget, bool is_thinned) {
  const double part =
      static_cast<double>(used) / static_cast<double>(std::max<std::size_t>(budget, 1));
  const QString text =
      Words::tr("%1 of %2 MB for samples")
          .arg(static_cast<double>(used) / kMega, 0, 'f', 1)
          .arg(static_cast<double>(budget) / kMega, 0, 'f', 0) +
      (is_thinned
           ? Words::tr(
                 "; of older samples, only the lowest and highest value of each 100 ms are kept")
           : "");
  setAccessibleName(text);
  setToolTip(text);
  part_ = std::clamp(part, 0.0, 1.0);
  is_thinned_ = is_thinned;
  update();
}

void MemoryMeter::paintEvent(QPaintEvent*) {
  const Theme& theme = Theme::instance();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  QRectF bar(0, (height() - kBarHeight) / 2.0, width(), kBarHeight);
  painter.setBrush(theme.color(Token::kLine));
  painter.drawRoundedRect(bar, kBarHeight / 2.0, kBarHeight / 2.0);
  bar.setWidth(std::max<double>(kBarHeight, bar.width() * part_));
  painter.setBrush(theme.color(is_thinned_ ? Token::kWarning : Token::kDim));
  painter.drawRoundedRect(bar, kBarHeight / 2.0, kBarHeight / 2.0);
}

}  // namespace tendon::gui
