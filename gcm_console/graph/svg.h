#pragma once

#include <gcm_console/graph/sheet.h>

#include <iosfwd>

namespace console {

/// Draws the sheet as a self-contained SVG on a light background.
void PrintSvg(const Sheet& sheet, std::ostream& out);

}  // namespace console
