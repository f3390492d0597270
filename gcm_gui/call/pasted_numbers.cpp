#include <gcm_gui/call/pasted_numbers.h>

#include <gcm_gui/language/words.h>
#include <tendon/payload/json/number_literal.h>

#include <QRegularExpression>

namespace tendon::gui {
namespace {

/// Removes only ASCII blanks around the text, because typographic blanks may separate thousands.
QString WithoutBlanksAround(QString text) {
  static const QRegularExpression around(QStringLiteral("^[ \\t\\r\\n]+|[ \\t\\r\\n]+$"));
  return text.remove(around);
}

/// Returns true for three or more parts such as "0.1,0.2,0.3", which cannot be one number.
bool IsListWithoutBlanks(const QString& text) {
  if (text.count(',') < 2) return false;
  return ReadNumberLiteral(Schema::Kind::kFloat64, text.toStdString()).meant.empty();
}

/// Returns true for "1 234.5", with any of the usual thousands separators.
bool MayBeOneNumber(const QString& text) {
  static const QRegularExpression thousands(
      QStringLiteral("^[+-]?\\d{1,3}([ '\u00a0\u2009\u202f\u2019]\\d{3})+([.,]\\d*)?$"));
  return thousands.match(text).hasMatch();
}

PastedNumbers Refused(const QString& refusal) {
  return {.is_list = true, .words = {}, .refusal = refusal};
}

}  // namespace

PastedNumbers NumbersIn(const QString& text) {
  static const QRegularExpression between(
      QStringLiteral(" *(?:(?:;|,(?=[ \\t\\n])) *[\\t\\n]?|\\t|\\n[ \\n]*) *| +"));
  static const QRegularExpression separator(QStringLiteral("[ \\t\\n;]"));
  static const QRegularExpression parts(QStringLiteral("[;\\t\\n]|,(?=[ \\t\\n])"));
  QString list = WithoutBlanksAround(text).replace(QStringLiteral("\r\n"), QStringLiteral("\n"));
  const bool is_in_brackets = list.startsWith('[') && list.endsWith(']');
  if (is_in_brackets) list = WithoutBlanksAround(list.mid(1, list.size() - 2));
  const bool is_json = is_in_brackets && !list.contains(separator);
  QStringList words = is_json ? list.split(',') : list.split(between);
  if (!is_in_brackets && words.size() == 1) {
    if (!IsListWithoutBlanks(list)) return {.is_list = false, .words = {text}, .refusal = {}};
    return Refused(Words::tr("put a space after each comma between numbers"));
  }
  if (words.contains(QString())) return Refused(Words::tr("a number is missing in the list"));
  for (const QString& part : list.split(parts)) {
    if (!MayBeOneNumber(part.trimmed())) continue;
    return Refused(
        Words::tr(
            "it is not clear whether “%1” is one number or several: put semicolons between numbers")
            .arg(part.trimmed()));
  }
  return {.is_list = true, .words = std::move(words), .refusal = {}};
}

}  // namespace tendon::gui
