#include <gcm_gui/models/number_flaw.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>

#include <QStringList>

namespace tendon::gui {

QString NumberFlawText(const NumberLiteral& word, const QString& unit) {
  QStringList meant;
  for (const std::string& one : word.meant) meant << ToQString(one);
  const QString write = meant.join(Words::tr(" or "));
  switch (word.flaw) {
    case NumberFlaw::kNone:
      return {};
    case NumberFlaw::kEmpty:
      return Words::tr("a number is missing");
    case NumberFlaw::kDecimalComma:
      return (meant.size() > 1 ? Words::tr("write %1: use a point as the decimal sign, and no "
                                           "separator between thousands")
                               : Words::tr("write %1: use a point as the decimal sign"))
          .arg(write);
    case NumberFlaw::kGroups:
      return Words::tr("write %1: use no separator between thousands").arg(write);
    case NumberFlaw::kSpelling:
      return Words::tr("write %1").arg(write);
    case NumberFlaw::kRest:
      return unit.isEmpty()
                 ? Words::tr("write the number alone, without “%1”").arg(ToQString(word.rest))
                 : Words::tr("write the number alone, in %1").arg(unit);
    case NumberFlaw::kFraction:
      return Words::tr("write a whole number");
    case NumberFlaw::kLimits:
      return Words::tr("the type of this field cannot hold this number");
    case NumberFlaw::kNoNumber:
      return Words::tr("write a number in digits");
  }
  return {};
}

}  // namespace tendon::gui
