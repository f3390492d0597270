#pragma once

#include <QString>

class QLabel;

namespace tendon::gui {

/// An empty label for plain text that wraps, with this style role; the caller owns it.
[[nodiscard]] QLabel* MakeTextLine(const QString& name, const QString& role);

}  // namespace tendon::gui
