#include <gcm_gui/call/number_field.h>

#include <gcm_gui/call/pasted_numbers.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/number_flaw.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/theme.h>

#include <QClipboard>
#include <QDropEvent>
#include <QFocusEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLocale>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionFrame>
#include <charconv>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr qsizetype kSurelySeen = 6;  // characters that are always visible
constexpr int kMaxDigits = 15;        // digits that every double keeps
constexpr int kInnerMargin = 2;       // QLineEdit's own margin beside its text
const QString kRole = QStringLiteral("mono number");

/// Returns the element type of a list; for any other type, the type itself.
const Schema& ElementOf(const Schema& schema) {
  const bool is_list =
      schema.kind() == Schema::Kind::kArray || schema.kind() == Schema::Kind::kSequence;
  return is_list ? schema.element() : schema;
}

std::optional<double> DoubleOf(const std::string& json) {
  double number = 0;
  const char* const end = json.data() + json.size();
  if (std::from_chars(json.data(), end, number).ptr != end) return std::nullopt;
  return number;
}

/// Formats a limit without rounding, because a rounded limit might be out of range.
QString LimitText(double limit) {
  return QString::number(limit, 'g', QLocale::FloatingPointShortest);
}

}  // namespace

NumberField::NumberField(const Schema::Field& field, QWidget* parent)
    : QLineEdit(parent),
      schema_(ElementOf(field.schema)),
      unit_(ToQString(field.unit)),
      range_(field.range),
      row_{this} {
  setAlignment(Qt::AlignRight);
  SetRole(*this, kRole);
  connect(this, &QLineEdit::textChanged, this, &NumberField::showChange);
}

void NumberField::setHelp(const QString& help) {
  help_ = help;
  showChange();
}

NumberLiteral NumberField::word() const {
  return ReadNumberLiteral(schema_.kind(), text().toStdString());
}

QString NumberField::refusal() const {
  const NumberLiteral found = word();
  if (found.flaw != NumberFlaw::kNone) return NumberFlawText(found, unit_);
  if (!range_) return {};
  const std::optional<double> number = DoubleOf(found.json);
  const bool is_inside = number && *number >= range_->lowest && *number <= range_->highest;
  // Infinity is allowed if it is a limit of the range; NaN is never in a range.
  const bool is_infinite = !number && ((found.json == "\"inf\"" && std::isinf(range_->highest)) ||
                                       (found.json == "\"-inf\"" && std::isinf(range_->lowest)));
  if (is_inside || is_infinite) return {};
  return Words::tr("write a number from %1 to %2")
      .arg(LimitText(range_->lowest), (LimitText(range_->highest) + ' ' + unit_).trimmed());
}

void NumberField::showChange() {
  paste_refusal_.clear();
  if (!hasFocus()) setCursorPosition(0);
  const QString whole = text().size() > kSurelySeen ? text() : QString();
  setToolTip(whole.isEmpty() ? help_ : whole + '\n' + help_);
  const QString wrong = refusal();
  SetRole(*this, wrong.isEmpty() ? kRole : kRole + QStringLiteral(" bad"));
  setAccessibleDescription(wrong);
}

bool NumberField::takeList(const QString& text) {
  if (isReadOnly()) return false;
  const PastedNumbers copied = NumbersIn(text);
  if (!copied.is_list) return false;
  const QString refusal = copied.refusal.isEmpty() ? refusalOfList(copied.words) : copied.refusal;
  if (!refusal.isEmpty()) {
    paste_refusal_ = Words::tr("Nothing was pasted: %1").arg(refusal);
    Q_EMIT pasteRefused();
    return true;
  }
  for (qsizetype i = 0; i < copied.words.size(); ++i) {
    NumberField& field = *row_[i];
    field.selectAll();
    field.insert(copied.words[i].trimmed());
    field.paste_refusal_.clear();
    if (!field.hasFocus()) field.setCursorPosition(0);
  }
  return true;
}

QString NumberField::refusalOfList(const QStringList& words) const {
  if (words.size() > row_.size()) {
    return row_.size() == 1 ? Words::tr("expected one number, found %1").arg(words.size())
                            : Words::tr("expected at most %2 numbers from this field on, found %1")
                                  .arg(words.size())
                                  .arg(row_.size());
  }
  for (qsizetype i = 0; i < words.size(); ++i) {
    const NumberLiteral word = ReadNumberLiteral(row_[i]->schema_.kind(), words[i].toStdString());
    if (word.flaw == NumberFlaw::kNone) continue;
    return QStringLiteral("“%1”: %2").arg(words[i], NumberFlawText(word, unit_));
  }
  return {};
}

void NumberField::paste() {
  if (!takeList(QGuiApplication::clipboard()->text())) QLineEdit::paste();
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  event->matches(QKeySequence::Paste) ? paste() : QLineEdit::keyPressEvent(event);
}

void NumberField::mouseReleaseEvent(QMouseEvent* event) {
  QClipboard& clipboard = *QGuiApplication::clipboard();
  const bool pastes = event->button() == Qt::MiddleButton && clipboard.supportsSelection();
  if (pastes && takeList(clipboard.text(QClipboard::Selection))) return;
  QLineEdit::mouseReleaseEvent(event);
}

void NumberField::dropEvent(QDropEvent* event) {
  if (takeList(event->mimeData()->text())) return event->acceptProposedAction();
  QLineEdit::dropEvent(event);
}

void NumberField::focusInEvent(QFocusEvent* event) {
  QLineEdit::focusInEvent(event);
  // If a key has moved the focus to this field, all text is selected. The cursor is put at the
  // beginning, so that the beginning is visible.
  if (hasSelectedText() && selectedText() == text()) {
    setSelection(static_cast<int>(text().size()), -static_cast<int>(text().size()));
  }
  update();
}

void NumberField::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  const bool is_left = event->reason() != Qt::PopupFocusReason;
  if (is_left) setCursorPosition(0);
  update();
}

QRect NumberField::contents() const {
  QStyleOptionFrame option;
  initStyleOption(&option);
  const QRect inside = style()->subElementRect(QStyle::SE_LineEditContents, &option, this);
  return inside.marginsRemoved(textMargins()).adjusted(kInnerMargin, 0, -kInnerMargin, 0);
}

QString NumberField::shownText() const {
  const QString whole = text();
  const QFontMetrics metrics(font());
  const int width = contents().width();
  const auto fits = [&](const QString& shown) { return metrics.horizontalAdvance(shown) <= width; };
  if (fits(whole)) return whole;
  const std::optional<double> number = DoubleOf(word().json);
  if (number && whole.contains('e', Qt::CaseInsensitive)) {
    // Rounds the number: its first digits without the exponent would be a different number.
    for (int digits = kMaxDigits; digits > 0; --digits) {
      const QString rounded = QString::number(*number, 'g', digits);
      if (fits(rounded)) return rounded;
    }
    return QStringLiteral("…");
  }
  for (qsizetype size = whole.size() - 1; size > 0; --size) {
    const QString front = whole.left(size) + QStringLiteral("…");
    if (fits(front)) return front;
  }
  return QStringLiteral("…");
}

void NumberField::paintEvent(QPaintEvent* event) {
  const QString shown = shownText();
  if (hasFocus() || shown == text()) return QLineEdit::paintEvent(event);
  QStyleOptionFrame option;
  initStyleOption(&option);
  QPainter painter(this);
  style()->drawPrimitive(QStyle::PE_PanelLineEdit, &option, &painter, this);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(contents(), Qt::AlignRight | Qt::AlignVCenter, shown);
}

}  // namespace tendon::gui
