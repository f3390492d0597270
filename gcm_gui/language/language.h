#pragma once

#include <QLocale>
#include <QStringList>

namespace tendon::gui {

/// The languages there are beside English, which needs no file: "de", "fr".
[[nodiscard]] QStringList Languages();

/// From now on the window speaks the language of `locale`, and Qt's own dialogs too; English where
/// there is no other. Numbers are the same in all of them: with a point, and nothing between
/// thousands, as commands, JSON and CSV have them. To be called once, before the first widget, on
/// the GUI thread.
void SpeakAs(const QLocale& locale);

}  // namespace tendon::gui
