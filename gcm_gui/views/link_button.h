#pragma once

#include <QString>

class QToolButton;

namespace tendon::gui {

/// Makes a button that looks like a link; `name` is its object name.
[[nodiscard]] QToolButton* MakeLinkButton(const QString& text, const QString& name);

}  // namespace tendon::gui
