#include <gcm_gui/call/number_box.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/number_flaw.h>

#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>

namespace tendon::gui {
namespace {

constexpr int kMaxDecimals = 15;

}  // namespace

NumberBox::NumberBox(Numbers numbers, QWidget* parent) : QDoubleSpinBox(parent), numbers_(numbers) {
  setButtonSymbols(NoButtons);  // not needed: the keys and the wheel do the same
  setDecimals(numbers == Numbers::kWhole ? 0 : kMaxDecimals);
  setLocale(QLocale::c());
  connect(lineEdit(), &QLineEdit::textChanged, this, &NumberBox::edited);
}

void NumberBox::keyPressEvent(QKeyEvent* event) {
  const bool is_enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (is_enter && !refusal().isEmpty()) return event->ignore();
  QDoubleSpinBox::keyPressEvent(event);
}

void NumberBox::focusOutEvent(QFocusEvent* event) {
  if (refusal().isEmpty()) return QDoubleSpinBox::focusOutEvent(event);
  lineEdit()->event(event);
  QWidget::focusOutEvent(event);
}

QString NumberBox::bareText(const QString& text) const {
  QString bare = text;
  if (!suffix().isEmpty() && bare.endsWith(suffix())) bare.chop(suffix().size());
  return bare.trimmed();
}

QString NumberBox::refusalOf(const QString& text) const {
  if (!specialValueText().isEmpty() && text == specialValueText()) return {};
  const auto kind = numbers_ == Numbers::kWhole ? Schema::Kind::kInt32 : Schema::Kind::kFloat64;
  const NumberLiteral word = ReadNumberLiteral(kind, bareText(text).toStdString());
  if (word.flaw != NumberFlaw::kNone) return NumberFlawText(word, suffix().trimmed());
  bool is_number = false;
  const double number = QString::fromStdString(word.json).toDouble(&is_number);
  if (!is_number || number < minimum() || number > maximum()) {
    return Words::tr("write a number from %1 to %2")
        .arg(textFromValue(minimum()), textFromValue(maximum()));
  }
  return {};
}

QString NumberBox::refusal() const { return refusalOf(text()); }

QValidator::State NumberBox::validate(QString& text, int& /*place*/) const {
  return refusalOf(text).isEmpty() ? QValidator::Acceptable : QValidator::Intermediate;
}

double NumberBox::valueFromText(const QString& text) const {
  if (!specialValueText().isEmpty() && text == specialValueText()) return minimum();
  const NumberLiteral word =
      ReadNumberLiteral(Schema::Kind::kFloat64, bareText(text).toStdString());
  bool is_number = false;
  const double number = QString::fromStdString(word.json).toDouble(&is_number);
  return is_number ? number : value();
}

QString NumberBox::textFromValue(double value) const { return QString::number(value, 'g', 10); }

}  // namespace tendon::gui
