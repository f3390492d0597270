#pragma once

#include <gcm_console/output/diagram.h>
#include <tendon/gcm/catalogue.h>

#include <iosfwd>

namespace console {

/// Prints the system for Graphviz. Each component is a box inside the box of its process. An arrow
/// leads from each required interface to the provided interface to which it is connected.
void PrintDot(const tendon::Catalogue& catalogue, std::ostream& out);

/// Prints the system with the positions of `arranged`, which must be a diagram of the same
/// catalogue.
void PrintDot(const tendon::Catalogue& catalogue, const Diagram& arranged, std::ostream& out);

}  // namespace console
