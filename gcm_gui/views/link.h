#pragma once

#include <QString>

class QToolButton;

namespace tendon::gui {

/// Words that do something when they are clicked; `name` is that of the object.
[[nodiscard]] QToolButton* MakeLink(const QString& text, const QString& name);

}  // namespace tendon::gui
