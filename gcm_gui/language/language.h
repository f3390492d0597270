#pragma once

#include <QLocale>
#include <QStringList>

namespace tendon::gui {

/// The available languages besides English, which needs no file: "de", "fr".
[[nodiscard]] QStringList Languages();

/// Sets the language of the window and of Qt's own dialogs to that of `locale`, or to English if
/// there is no translation. Numbers stay the same in every language: a decimal point and no
/// thousands separators, as in commands, JSON and CSV. Call it once, before the first widget, on
/// the GUI thread.
void SpeakAs(const QLocale& locale);

}  // namespace tendon::gui
