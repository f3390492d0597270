#include <gcm_gui/views/row_delegate.h>

#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/sparkline.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/state_mark.h>
#include <gcm_gui/theme/theme.h>

#include <QAbstractItemView>
#include <QFontMetrics>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tendon::gui {
namespace {

constexpr int kGlyphWidth = 16;
constexpr int kSpace = 6;
constexpr int kTrendWidth = 48;
constexpr int kTrendRight = 108;   // from the left edge of a trend to the right edge of the row
constexpr int kHeaderPadding = 8;  // pixels to the left of a text, as in the header above it

/// Draws as much of `text` as fits, and returns the width used.
int PaintText(QPainter& painter, const QRect& rect, const QString& text, const QFont& font,
              Token token, Qt::Alignment side, Qt::TextElideMode elide = Qt::ElideRight) {
  if (text.isEmpty() || rect.width() <= 0) return 0;
  const QFontMetrics metrics(font);
  const QString shown = metrics.elidedText(text, elide, rect.width());
  painter.setFont(font);
  painter.setPen(Theme::instance().color(token));
  painter.drawText(rect, static_cast<int>(side | Qt::AlignVCenter) | Qt::TextSingleLine, shown);
  return metrics.horizontalAdvance(shown);
}

/// Draws a detail, or nothing if only a few letters would fit. Returns the width used. If
/// necessary, "suspended · 5 s old" is shortened to the age, because the state of the component is
/// shown elsewhere.
int PaintDetail(QPainter& painter, const QRect& rect, QString text) {
  constexpr int kFewest = 8;  // characters
  const QFont& mono = Theme::instance().mono();
  const QFontMetrics metrics(mono);
  if (rect.width() < metrics.horizontalAdvance(text)) {
    text = text.section(QStringLiteral(" · "), -1);
  }
  if (rect.width() < metrics.horizontalAdvance(text.left(kFewest))) return 0;
  return PaintText(painter, rect, text, mono, Token::kDim, Qt::AlignLeft);
}

/// Tints the background of a text of this width at the right end of `room`.
void PaintTint(QPainter& painter, const QRect& room, int width) {
  const int left = std::max(room.left(), room.right() - width - 4);
  painter.fillRect(QRect(QPoint(left, room.top() + 3), QPoint(room.right() + 3, room.bottom() - 3)),
                   Theme::instance().color(Token::kAccent, 0.18));
}

QFont FontOf(const QModelIndex& index) {
  const Theme& theme = Theme::instance();
  switch (static_cast<FontStyle>(index.data(kFontStyleRole).toInt())) {
    case FontStyle::kStrong:
      return theme.strong();
    case FontStyle::kMono:
      return theme.mono();
    case FontStyle::kPlain:
      break;
  }
  return theme.text();
}

}  // namespace

QSize RowDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  return {QStyledItemDelegate::sizeHint(option, index).width(), kRowHeight};
}

void RowDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const {
  painter->save();
  QRect rect = option.rect;
  if (const auto* view = qobject_cast<const QAbstractItemView*>(option.widget)) {
    // Leaves room for the buttons at the right end of the row.
    const QWidget* buttons = view->indexWidget(index);
    if (buttons != nullptr) rect.setRight(rect.right() - buttons->childrenRect().width() - kInset);
  }
  const bool is_value = index.column() > 0 && !all_left_ && !index.data(kLeftRole).toBool();
  const QRect row = rect;
  const bool has_value = index.column() == 0 && value_column_ >= 0;
  if (has_value) {
    rect =
        paintValue(*painter, rect, index.siblingAtColumn(value_column_), roomForName(rect, index));
    rect.setRight(rect.right() - kSpace);
  }
  if (const QString trail = index.data(kTrailRole).toString(); !trail.isEmpty()) {
    rect.setRight(rect.right() - kInset);
    const int used =
        PaintText(*painter, rect, trail, Theme::instance().text(), Token::kDim, Qt::AlignRight);
    rect.setRight(rect.right() - used - kSpace);
  }
  if (is_value) {
    paintValue(*painter, rect, index, 0);
  } else {
    const QRect free = paintName(*painter, rect, index);
    if (has_value) paintTrend(*painter, row, free, index);
  }
  painter->restore();
}

/// Returns the width that the name needs, up to a limit. The name has priority, because a value
/// without a name is useless.
int RowDelegate::roomForName(const QRect& rect, const QModelIndex& index) const {
  const int name = left_inset_ + kGlyphWidth + kSpace / 2 + kSpace +
                   QFontMetrics(FontOf(index)).horizontalAdvance(index.data().toString());
  const int width = rect.width() - kInset;
  return std::clamp(name, width / 4, width * 3 / 5);
}

QRect RowDelegate::paintValue(QPainter& painter, QRect rect, const QModelIndex& index,
                              int name) const {
  const Theme& theme = Theme::instance();
  const bool stale = index.data(kStaleRole).toBool();
  const bool accent = index.data(kAccentRole).toBool();
  const bool prose = index.data(kProseRole).toBool();
  const QString text = index.data().toString();
  rect.setRight(rect.right() - kInset);

  const QRect room = rect.adjusted(name, 0, 0, 0);
  int used = 0;
  if (const QString unit = index.data(kUnitRole).toString(); !unit.isEmpty()) {
    used = PaintText(painter, room, unit, theme.mono(), Token::kDim, Qt::AlignRight) + kSpace;
  }
  const Token token = accent                                     ? Token::kAccent
                      : stale || index.data(kQuietRole).toBool() ? Token::kDim
                                                                 : Token::kText;
  const QFont& font = prose ? theme.text() : theme.mono();
  if (index.data(kFreshRole).toBool()) {
    PaintTint(painter, room.adjusted(0, 0, -used, 0), QFontMetrics(font).horizontalAdvance(text));
  }
  used += PaintText(painter, room.adjusted(0, 0, -used, 0), text, font, token, Qt::AlignRight);
  const QVariant mark = index.data(kMarkRole);
  if (mark.isValid()) {
    const QRect place(rect.right() - used - kGlyphWidth - 2, rect.top(), kGlyphWidth,
                      rect.height());
    painter.setOpacity(stale ? kStaleMarkOpacity : 1.0);
    PaintMark(painter, place, mark.value<StateMark>());
    painter.setOpacity(1.0);
    used += kGlyphWidth + 2;
  }
  return rect.adjusted(0, 0, -used, 0);
}

void RowDelegate::paintTrend(QPainter& painter, const QRect& row, const QRect& free,
                             const QModelIndex& index) const {
  const auto trend = index.data(kSparklineRole).value<Sparkline>();
  const QRect place(row.right() - kTrendRight - kTrendWidth, row.top() + 5, kTrendWidth,
                    row.height() - 10);
  const bool is_free = free.left() <= place.left() && place.right() <= free.right();
  if (trend.parts.size() < 2 || !is_free) return;
  const bool stale = index.data(kStaleRole).toBool();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(Theme::instance().color(stale ? Token::kStale : Token::kAccent), 1.2));
  // The newest value is always at the right edge.
  const double step = place.width() / 99.0;
  QPolygonF line;
  for (qsizetype i = 0; i < trend.parts.size(); ++i) {
    if (std::isnan(trend.parts[i])) {
      painter.drawPolyline(std::exchange(line, {}));
      continue;
    }
    const QPointF point(place.right() - step * static_cast<double>(trend.parts.size() - 1 - i),
                        place.bottom() - trend.parts[i] * place.height());
    if (trend.is_stepped && !line.isEmpty()) line << QPointF(point.x(), line.last().y());
    line << point;
  }
  painter.drawPolyline(line);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

QRect RowDelegate::paintName(QPainter& painter, QRect rect, const QModelIndex& index) const {
  rect.setLeft(rect.left() + (index.column() == 0 ? left_inset_ : kHeaderPadding));
  const bool stale = index.data(kStaleRole).toBool();
  if (const QString time = index.data(kTimeRole).toString(); !time.isEmpty()) {
    const QFont& mono = Theme::instance().mono();
    rect.setLeft(rect.left() + kSpace +
                 PaintText(painter, rect, time, mono, Token::kDim, Qt::AlignLeft));
  }
  const QVariant mark = index.data(kGlyphMarkRole);
  const QString glyph = index.data(kGlyphRole).toString();
  const QRect place(rect.left(), rect.top(), kGlyphWidth, rect.height());
  if (mark.isValid()) {
    painter.setOpacity(stale ? kStaleMarkOpacity : 1.0);
    PaintMark(painter, place, mark.value<StateMark>());
    painter.setOpacity(1.0);
  } else if (!glyph.isEmpty()) {
    const Token token = index.data(kAccentRole).toBool() ? Token::kAccent : Token::kDim;
    PaintText(painter, place, glyph, Theme::instance().text(), token, Qt::AlignHCenter);
  }
  if (mark.isValid() || !glyph.isEmpty()) rect.setLeft(rect.left() + kGlyphWidth + kSpace / 2);

  QFont font = FontOf(index);
  font.setStrikeOut(index.data(kStruckRole).toBool());
  const bool quiet = stale || index.data(kQuietRole).toBool();
  if (index.data(kFreshRole).toBool()) font.setBold(true);
  // A path is shortened in the middle, because its end is its most specific part.
  const bool path = static_cast<FontStyle>(index.data(kFontStyleRole).toInt()) == FontStyle::kMono;
  const int used =
      PaintText(painter, rect, index.data().toString(), font, quiet ? Token::kDim : Token::kText,
                Qt::AlignLeft, path ? Qt::ElideMiddle : Qt::ElideRight);
  rect.setLeft(rect.left() + used + kSpace);
  if (const QString object = index.data(kObjectRole).toString(); !object.isEmpty()) {
    const QFont& mono = Theme::instance().mono();
    const int width = PaintText(painter, rect, object, mono, Token::kText, Qt::AlignLeft);
    rect.setLeft(rect.left() + width + 2 * kSpace);
  }
  const int detail = PaintDetail(painter, rect, index.data(kDetailRole).toString());
  if (detail > 0) rect.setLeft(rect.left() + detail + kSpace);
  return rect;
}

}  // namespace tendon::gui
