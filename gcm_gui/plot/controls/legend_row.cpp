#include <gcm_gui/plot/controls/legend_row.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/theme.h>

#include <QApplication>
#include <QContextMenuEvent>
#include <QFontMetrics>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr int kLegendRowHeight = 18;
constexpr int kSwatchWidth = 12;
constexpr int kSwatchHeight = 3;
constexpr int kSwatchGap = 2;  // of a recorded curve
constexpr int kSpace = 8;
constexpr int kWidestName = 220;
constexpr int kWidestFile = 140;
constexpr double kHiddenOpacity = 0.45;

// Stores a text with its layout. The legend paints the text in each frame of the plot, so the
// layout is not computed each time.
void SetText(QStaticText& text, const QString& content, const QFont& font) {
  if (text.text() == content) return;
  text.setTextFormat(Qt::PlainText);
  text.setText(content);
  text.prepare({}, font);
}

int WidthOf(const QStaticText& text) { return static_cast<int>(std::ceil(text.size().width())); }

}  // namespace

LegendRow::LegendRow(QWidget* parent) : QWidget(parent) {
  setFixedHeight(kLegendRowHeight);
  setFocusPolicy(Qt::TabFocus);
  setCursor(Qt::PointingHandCursor);
}

void LegendRow::setEntry(const LegendEntry& entry) {
  if (entry == entry_) return;
  entry_ = entry;
  setObjectName("legend:" + entry.path);
  setAccessibleName(
      QStringList{entry.recording, entry.name, entry.value, entry.unit}.join(' ').simplified());
  const QString path = FullName(entry.path);
  setToolTip(isGrey() ? path + '\n' + entry.name : path);
  const QFontMetrics metrics(Theme::instance().small());
  // Shortens a name such as "arm.position[0] · suspended · 5 s old" in the middle of its path. The
  // ends of the path stay visible, because they distinguish the curves.
  const qsizetype reason = entry.name.indexOf(QStringLiteral(" · "));
  QString name = metrics.elidedText(entry.name.left(reason), Qt::ElideMiddle, kWidestName);
  if (reason >= 0) name += metrics.elidedText(entry.name.mid(reason), Qt::ElideRight, kWidestName);
  if (!entry.recording.isEmpty()) {
    const QString file = metrics.elidedText(entry.recording, Qt::ElideMiddle, kWidestFile);
    name = file + QStringLiteral(" · ") + name;
  }
  SetText(name_, name, Theme::instance().small());
  SetText(value_, isRemappable() ? Words::tr("remap…") : entry.value,
          Theme::instance().smallMono());
  SetText(unit_, entry.unit, Theme::instance().small());
  SetText(figures_, entry.figures, Theme::instance().smallMono());
  update();
}

int LegendRow::nameWidth() const { return WidthOf(name_); }

int LegendRow::valueWidth() const { return WidthOf(value_); }

int LegendRow::unitWidth() const { return WidthOf(unit_); }

void LegendRow::setColumns(int name_width, int value_width, int unit_width) {
  name_width_ = name_width;
  value_width_ = value_width;
  unit_width_ = unit_width;
  setFixedWidth(kSwatchWidth + kSpace + name_width + kSpace + value_width +
                (unit_width > 0 ? kSpace / 2 + unit_width : 0) +
                (entry_.figures.isEmpty() ? 0 : 2 * kSpace + WidthOf(figures_)));
}

QRect LegendRow::valueRect() const {
  return {kSwatchWidth + kSpace + name_width_ + kSpace, 0, value_width_, height()};
}

QRect LegendRow::markRect() const {
  return {0, (height() - kSwatchWidth) / 2, kSwatchWidth, kSwatchWidth};
}

bool LegendRow::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::Enter:
    case QEvent::Leave:
    case QEvent::FocusIn:
    case QEvent::FocusOut:
      update();
      break;
    case QEvent::ShortcutOverride:
      // If the row uses a key, the shortcut of the window with the same key is not called.
      if (isOwnKey(static_cast<QKeyEvent*>(event)->key())) event->accept();
      break;
    default:
      break;
  }
  return QWidget::event(event);
}

void LegendRow::paintMark(QPainter& painter) const {
  const Theme& theme = Theme::instance();
  if (isPointedAt()) return PaintIcon(painter, markRect(), "close", Token::kText);
  // Old values and recorded values keep the colour of their curve.
  const QColor color =
      isRemappable() ? theme.color(Token::kStale) : theme.curve(entry_.color_index);
  const int top = (height() - kSwatchHeight) / 2;
  if (entry_.recording.isEmpty())
    return painter.fillRect(0, top, kSwatchWidth, kSwatchHeight, color);
  const int dash = (kSwatchWidth - kSwatchGap) / 2;
  painter.fillRect(0, top, dash, kSwatchHeight, color);
  painter.fillRect(kSwatchWidth - dash, top, dash, kSwatchHeight, color);
}

void LegendRow::paintEvent(QPaintEvent*) {
  const Theme& theme = Theme::instance();
  QPainter painter(this);
  painter.setOpacity(entry_.shown ? 1.0 : kHiddenOpacity);
  paintMark(painter);
  const auto paint = [&](int x, const QStaticText& text, const QFont& font, Token token) {
    painter.setFont(font);
    painter.setPen(theme.color(token));
    painter.drawStaticText(QPointF(x, (height() - text.size().height()) / 2), text);
  };
  const Token token = isGrey() ? Token::kDim : Token::kText;
  const int name_left = kSwatchWidth + kSpace;
  const int value_right = name_left + name_width_ + kSpace + value_width_;
  paint(name_left, name_, theme.small(), token);
  paint(value_right - WidthOf(value_), value_, theme.smallMono(),
        isRemappable() ? Token::kAccent : token);
  paint(value_right + kSpace / 2, unit_, theme.small(), Token::kDim);
  paint(value_right + kSpace / 2 + unit_width_ + 2 * kSpace, figures_, theme.smallMono(),
        Token::kDim);
  if (!hasFocus()) return;
  painter.setPen(theme.color(Token::kAccent));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void LegendRow::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  pressed_ = event->pos();
}

void LegendRow::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) return;
  const QPoint moved = event->pos() - *pressed_;
  if (moved.manhattanLength() < QApplication::startDragDistance()) return;
  pressed_.reset();
  Q_EMIT dragRequested(entry_.path);
}

void LegendRow::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !pressed_) return event->ignore();
  pressed_.reset();
  if (markRect().contains(event->pos())) {
    Q_EMIT removeRequested(entry_.path);
  } else if (isRemappable() && valueRect().contains(event->pos())) {
    Q_EMIT remapRequested(entry_.path);
  } else {
    Q_EMIT toggled(entry_.path);
  }
}

bool LegendRow::isOwnKey(int key) {
  return key == Qt::Key_Delete || key == Qt::Key_Backspace || key == Qt::Key_Space ||
         key == Qt::Key_R || key == Qt::Key_Return || key == Qt::Key_Enter;
}

void LegendRow::keyPressEvent(QKeyEvent* event) {
  if (!isOwnKey(event->key())) return QWidget::keyPressEvent(event);
  switch (event->key()) {
    case Qt::Key_Space:
      return Q_EMIT toggled(entry_.path);
    case Qt::Key_R:
      if (!entry_.recording.isEmpty()) return;
      return Q_EMIT remapRequested(entry_.path);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return Q_EMIT lookRequested(entry_.path);
    default:
      return Q_EMIT removeRequested(entry_.path);
  }
}

void LegendRow::contextMenuEvent(QContextMenuEvent* event) {
  auto* menu = new QMenu(this);
  menu->setObjectName("legendMenu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto add = [&](const QString& text, Qt::Key key, void (LegendRow::*wish)(const QString&)) {
    menu->addAction(text, this, [this, wish] { (this->*wish)(entry_.path); })->setShortcut(key);
  };
  const bool is_recorded = !entry_.recording.isEmpty();
  add(is_recorded ? Words::tr("Shift, scale, offset and axis…")
                  : Words::tr("Scale, offset and axis…"),
      Qt::Key_Return, &LegendRow::lookRequested);
  add(entry_.shown ? Words::tr("Hide") : Words::tr("Show"), Qt::Key_Space, &LegendRow::toggled);
  if (!is_recorded) {
    add(Words::tr("Show another signal…"), Qt::Key_R, &LegendRow::remapRequested);
  }
  add(Words::tr("Remove"), Qt::Key_Delete, &LegendRow::removeRequested);
  menu->popup(event->globalPos());
}

}  // namespace tendon::gui
