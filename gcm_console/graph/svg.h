#pragma once

#include <gcm_console/graph/sheet.h>

#include <iosfwd>

namespace console {

/// Draws it as an SVG that stands alone, on a light ground.
void PrintSvg(const Sheet& sheet, std::ostream& out);

}  // namespace console
