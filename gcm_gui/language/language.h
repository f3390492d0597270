#pragma once

#include <QLocale>
#include <QStringList>

namespace tendon::gui {

/// The available languages besides English: "de", "fr". English needs no file.
[[nodiscard]] QStringList Languages();

/// Sets the language of the window and of Qt's own dialogs to the one of `locale`, or to English if
/// there is no translation. Numbers look the same in every language, as in commands, JSON and CSV:
/// with a decimal point and without thousands separators. Call it once, before the first widget is
/// created, in the GUI thread.
void SetLanguage(const QLocale& locale);

}  // namespace tendon::gui
