#pragma once

#include <tendon/manager/component_description.h>

#include <QStringList>

namespace tendon::gui {

/// All counters of a connection, one sentence per line.
[[nodiscard]] QStringList CountsLines(const ConnectionCounts& counts);

}  // namespace tendon::gui
