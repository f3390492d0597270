#include <gcm_gui/plot/controls/plot_overlay.h>

#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QEvent>
#include <QFontMetrics>
#include <QPainter>

namespace tendon::gui {

PlotOverlay::PlotOverlay(QWidget* canvas) : QWidget(canvas) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setGeometry(canvas->rect());
  canvas->installEventFilter(this);
  hide();
  connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

bool PlotOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parent() && event->type() == QEvent::Resize) {
    setGeometry(parentWidget()->rect());
  }
  return QWidget::eventFilter(watched, event);
}

void PlotOverlay::setRubberBand(const std::optional<QRect>& rect) {
  if (rect == band_) return;
  band_ = rect;
  changed();
}

void PlotOverlay::setHairline(std::optional<int> x, const QString& text) {
  if (x == line_ && text == line_text_) return;
  line_ = x;
  line_text_ = text;
  changed();
}

void PlotOverlay::setHint(const QString& hint) {
  if (hint == hint_) return;
  hint_ = hint;
  changed();
}

void PlotOverlay::setNote(const QString& note) {
  if (note == note_) return;
  note_ = note;
  changed();
}

// Hides the overlay while it is empty, because it is as large as the canvas.
void PlotOverlay::changed() {
  setVisible(band_.has_value() || line_.has_value() || !hint_.isEmpty() || !note_.isEmpty());
  update();
}

void PlotOverlay::paintEvent(QPaintEvent*) {
  const Theme& theme = Theme::instance();
  QPainter painter(this);
  if (!hint_.isEmpty()) {
    painter.setFont(theme.text());
    painter.setPen(theme.color(Token::kDim));
    painter.drawText(rect(), Qt::AlignCenter, hint_);
  }
  if (band_) {
    painter.setPen(theme.color(Token::kAccent));
    painter.setBrush(theme.color(Token::kAccent, 0.12));
    painter.drawRect(band_->adjusted(0, 0, -1, -1));
  }
  if (line_) paintHairline(painter);
  if (!note_.isEmpty()) paintNote(painter);
}

void PlotOverlay::paintNote(QPainter& painter) const {
  const Theme& theme = Theme::instance();
  const QFontMetrics metrics(theme.small());
  const QString text = metrics.elidedText(note_, Qt::ElideRight, width() / 2);
  const QRect box(2 * kGrid, 2 * kGrid, metrics.horizontalAdvance(text) + 4 * kGrid,
                  metrics.height() + kGrid);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.color(Token::kPanel, 0.9));
  painter.drawRoundedRect(box, kGrid, kGrid);
  painter.setFont(theme.small());
  painter.setPen(theme.color(Token::kWarning));
  painter.drawText(box, Qt::AlignCenter, text);
  painter.restore();
}

void PlotOverlay::paintHairline(QPainter& painter) const {
  const Theme& theme = Theme::instance();
  painter.setPen(theme.color(Token::kText, 0.7));
  painter.drawLine(*line_, 0, *line_, height());
  if (line_text_.isEmpty()) return;
  const QFontMetrics metrics(theme.smallMono());
  const int text_width = metrics.horizontalAdvance(line_text_) + 2 * kGrid;
  const int text_height = metrics.height() + 2;
  const bool fits = *line_ + kGrid + text_width < width();
  const int x = fits ? *line_ + kGrid : *line_ - kGrid - text_width;
  const QRect box(x, height() - text_height - kGrid, text_width, text_height);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.color(Token::kPanel, 0.9));
  painter.drawRoundedRect(box, 3, 3);
  painter.setFont(theme.smallMono());
  painter.setPen(theme.color(Token::kText));
  painter.drawText(box, Qt::AlignCenter, line_text_);
}

}  // namespace tendon::gui
