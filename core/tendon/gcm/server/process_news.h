#pragma once

#include <tendon/process/description.h>

#include <vector>

namespace tendon::server {

/// Logs processes that come and go.
void LogProcesses(const std::vector<CatalogChange>& changes);

[[nodiscard]] bool ChangesProcesses(const std::vector<CatalogChange>& changes);

}  // namespace tendon::server
