#pragma once

#include <QString>
#include <QStringList>

namespace tendon::gui {

/// The numbers in a text from the clipboard, for number fields.
struct PastedNumbers {
  bool is_list = false;  ///< several numbers; if false, `words` is the whole text
  QStringList words;     ///< the numbers as written, valid or not
  QString refusal;       ///< the reason why a list cannot be split, as a sentence for the user;
                         ///< otherwise empty
};

/// Splits a list only at unambiguous places: at line ends, tabs, semicolons and blanks; at commas
/// followed by a blank; and at the commas of a JSON list without blanks. Refuses a list with an
/// empty element, because all later numbers would move to other fields.
[[nodiscard]] PastedNumbers NumbersIn(const QString& text);

}  // namespace tendon::gui
