#pragma once

#include <QCoreApplication>

namespace tendon::gui {

/// The sentences of the window: Words::tr("Pause the view") is what the user reads, in the language
/// of his desktop. Names of the model (kinds, paths, commands) stay as the console says them, and
/// so do states where a filter looks for them. Any thread.
struct Words {
  Q_DECLARE_TR_FUNCTIONS(Words)
};

}  // namespace tendon::gui
