#include <gcm_gui/plot/canvas/mark_flags.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/theme.h>
#include <qwt_scale_map.h>

#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tendon::gui {
namespace {

constexpr double kFlagLayer = 30;  // above the curves, below the cursors
constexpr double kFlagGrab = 4;    // pixels to the left of a line that still belong to the flag
constexpr double kStroke = 2;      // width of a line
constexpr double kHeight = 16;
constexpr int kIconSize = 12;
constexpr double kFlagSpace = 3;
constexpr double kBackground = 0.82;
constexpr int kMaxFlagLines = 12;

const char* IconOf(Mark::Kind kind) {
  switch (kind) {
    case Mark::Kind::kCommand:
      return "command";
    case Mark::Kind::kEvent:
      return "event";
    case Mark::Kind::kState:
      return "component";
    case Mark::Kind::kConnection:
      return "connect";
  }
  return "event";
}

Token TokenOf(const Mark& mark) {
  if (mark.is_bad) return Token::kBad;
  switch (mark.kind) {
    case Mark::Kind::kCommand:
      return Token::kAccent;
    case Mark::Kind::kEvent:
      return Token::kWarning;
    case Mark::Kind::kState:
    case Mark::Kind::kConnection:
      break;
  }
  return Token::kOk;
}

/// Returns the mark that stands for all marks of a flag: the first bad one; if none is bad, the
/// first.
const Mark& ShownMark(const MarkFlags::Flag& flag) {
  const auto bad = std::find_if(flag.marks.begin(), flag.marks.end(),
                                [](const Mark* mark) { return mark->is_bad; });
  return bad == flag.marks.end() ? *flag.marks.front() : **bad;
}

QString LabelOf(const MarkFlags::Flag& flag) {
  const QString label = ShownMark(flag).label;
  if (flag.marks.size() == 1) return label;
  return QString("%1 +%2").arg(label).arg(flag.marks.size() - 1);
}

}  // namespace

MarkFlags::MarkFlags(const MarkTrack& track, const TimeWindow& window)
    : track_(track), window_(window) {
  setZ(kFlagLayer);
  setItemAttribute(Legend, false);
  setItemAttribute(AutoScale, false);
}

std::vector<MarkFlags::Flag> MarkFlags::flags(const QwtScaleMap& x_map,
                                              const QRectF& canvas_rect) const {
  const QFontMetricsF metrics(Theme::instance().small());
  const auto [first, end] = track_.between(window_.timeAt(x_map.invTransform(canvas_rect.left())),
                                           window_.timeAt(x_map.invTransform(canvas_rect.right())));
  std::vector<Flag> flags;
  for (auto mark = first; mark != end; ++mark) {
    const double x = std::round(x_map.transform(window_.secondsAt(mark->time_ns)));
    if (flags.empty() || x >= flags.back().end) flags.push_back({.x = x});
    Flag& flag = flags.back();
    flag.marks.push_back(&*mark);
    flag.label = LabelOf(flag);
    flag.end =
        flag.x + kStroke + kIconSize + 3 * kFlagSpace + metrics.horizontalAdvance(flag.label);
  }
  return flags;
}

QString MarkFlags::textAt(double x, const QwtScaleMap& x_map, const QRectF& canvas_rect) const {
  for (const Flag& flag : flags(x_map, canvas_rect)) {
    if (x < flag.x - kFlagGrab || x >= flag.end) continue;
    QStringList lines;
    for (const Mark* mark : flag.marks) {
      if (lines.size() < kMaxFlagLines) lines << mark->text;
    }
    const auto rest = static_cast<qsizetype>(flag.marks.size()) - lines.size();
    if (rest > 0) lines << Words::tr("and %1 more").arg(rest);
    return lines.join('\n');
  }
  return {};
}

QString MarkFlags::textBetween(std::int64_t from_ns, std::int64_t to_ns) const {
  const auto [first, end] = track_.between(from_ns, to_ns);
  QStringList lines;
  for (auto mark = end - std::min<std::ptrdiff_t>(end - first, kMaxFlagLines); mark != end;
       ++mark) {
    lines << mark->text;
  }
  return lines.join('\n');
}

void MarkFlags::draw(QPainter* painter, const QwtScaleMap& x_map, const QwtScaleMap&,
                     const QRectF& canvas_rect) const {
  const Theme& theme = Theme::instance();
  const double top = canvas_rect.bottom() - kHeight;
  painter->save();
  painter->setFont(theme.small());
  for (const Flag& flag : flags(x_map, canvas_rect)) {
    const Token token = TokenOf(ShownMark(flag));
    for (const Mark* mark : flag.marks) {
      const double x = std::round(x_map.transform(window_.secondsAt(mark->time_ns)));
      painter->fillRect(QRectF(x, top, kStroke, kHeight), theme.color(TokenOf(*mark)));
    }
    const QRectF body(flag.x + kStroke, top, flag.end - flag.x - kStroke, kHeight);
    painter->fillRect(body & canvas_rect, theme.color(Token::kPanel, kBackground));
    const QRect icon(static_cast<int>(body.left() + kFlagSpace),
                     static_cast<int>(top + (kHeight - kIconSize) / 2), kIconSize, kIconSize);
    PaintIcon(*painter, icon, IconOf(ShownMark(flag).kind), token);
    painter->setPen(theme.color(token));
    painter->drawText(body.adjusted(kIconSize + 2 * kFlagSpace, 0, 0, 0),
                      Qt::AlignLeft | Qt::AlignVCenter, flag.label);
  }
  painter->restore();
}

}  // namespace tendon::gui
