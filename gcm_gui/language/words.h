#pragma once

#include <QCoreApplication>

namespace tendon::gui {

/// The texts of the window: Words::tr("Pause the view") returns the text in the user's language.
/// Names of the model (kinds, paths, commands) stay as in the console, and so do states that a
/// filter looks for. Any thread.
struct Words {
  Q_DECLARE_TR_FUNCTIONS(Words)
};

}  // namespace tendon::gui
