#pragma once

#include <gcm_console/output/diagram.h>
#include <tendon/gcm/catalogue.h>

#include <iosfwd>

namespace console {

/// Prints the system for Graphviz: a box per component inside the box of its process, and an arrow
/// from each required interface to the interface it is connected to.
void PrintDot(const tendon::Catalogue& catalogue, std::ostream& out);

/// The same, with the positions of `arranged`, a diagram of the same catalogue.
void PrintDot(const tendon::Catalogue& catalogue, const Diagram& arranged, std::ostream& out);

}  // namespace console
