#pragma once

#include <QString>

class QLabel;

namespace tendon::gui {

/// An empty label for plain text, which wraps, in the look of this role; the caller owns it.
[[nodiscard]] QLabel* MakeTextLine(const QString& name, const QString& role);

}  // namespace tendon::gui
