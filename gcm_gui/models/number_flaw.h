#pragma once

#include <tendon/payload/json/number_literal.h>

#include <QString>

namespace tendon::gui {

/// Returns the mistake in a typed number and what to write instead, in the user's language: "write
/// 0.5: use a point as the decimal sign". Empty if the number is valid. `unit` may be empty.
[[nodiscard]] QString NumberFlawText(const NumberLiteral& word, const QString& unit = {});

}  // namespace tendon::gui
