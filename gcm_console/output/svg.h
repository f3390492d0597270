#pragma once

#include <gcm_console/output/diagram.h>

#include <iosfwd>

namespace console {

/// Draws the diagram as a self-contained SVG on a light background.
void PrintSvg(const Diagram& diagram, std::ostream& out);

}  // namespace console
