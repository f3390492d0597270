#pragma once

#include <tendon/manager/description.h>

#include <QStringList>

namespace tendon::gui {

/// All that a connection has counted, a sentence a line.
[[nodiscard]] QStringList CountsLines(const ConnectionCounts& counts);

}  // namespace tendon::gui
