#pragma once

#include <QString>
#include <QStringList>

namespace tendon::gui {

/// What a text from the clipboard holds for fields of numbers.
struct CopiedNumbers {
  bool is_list = false;  ///< more than what belongs into one field; else `words` is that text
  QStringList words;     ///< as they are written, right or wrong
  QString refusal;       ///< why a list cannot be taken apart: a sentence for the user
};

/// Takes a list apart where it can be meant in one way only: at line ends, tabs, semicolons and
/// blanks, at commas with a blank behind them, and at the commas of a JSON list without blanks. An
/// empty place in it is not passed over, as all behind it would move to other fields.
[[nodiscard]] CopiedNumbers NumbersIn(const QString& text);

}  // namespace tendon::gui
