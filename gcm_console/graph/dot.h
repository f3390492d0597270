#pragma once

#include <gcm_console/graph/sheet.h>
#include <tendon/gcm/catalog.h>

#include <iosfwd>

namespace console {

/// For Graphviz: a box for each component, within one for its process, and an arrow from each
/// required interface to what it is connected to.
void PrintDot(const tendon::Catalog& catalog, std::ostream& out);

/// And all of it stands where it does in `arranged`, a sheet of the same catalogue.
void PrintDot(const tendon::Catalog& catalog, const Sheet& arranged, std::ostream& out);

}  // namespace console
