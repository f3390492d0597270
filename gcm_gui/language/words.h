#pragma once

#include <QCoreApplication>

namespace tendon::gui {

/// Translates the texts of the window: Words::tr("Pause the view") returns the text in the user's
/// language. Names of the model (kinds, paths, commands) are not translated. States that a filter
/// can search for are not translated either. Both are the same as in the console. Any thread.
struct Words {
  Q_DECLARE_TR_FUNCTIONS(Words)
};

}  // namespace tendon::gui
