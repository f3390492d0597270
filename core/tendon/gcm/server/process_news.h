#pragma once

#include <tendon/process/process_description.h>

#include <vector>

namespace tendon::server {

/// Logs processes that come and go.
void LogProcesses(const std::vector<CatalogueChange>& changes);

[[nodiscard]] bool ChangesProcesses(const std::vector<CatalogueChange>& changes);

}  // namespace tendon::server
