#include <tendon/base/log.h>
#include <tendon/gcm/server/process_news.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace tendon::server {
namespace {

std::string_view Words(ProcessState state) {
  switch (state) {
    case ProcessState::kAlive:
      return "is available";
    case ProcessState::kSuspect:
      return "is suspect";
    case ProcessState::kLost:
      return "is lost";
    case ProcessState::kLeft:
      return "has left";
    case ProcessState::kStarting:
      return "is starting";
  }
  return "?";
}

}  // namespace

void LogProcesses(const std::vector<CatalogueChange>& changes) {
  for (const CatalogueChange& change : changes) {
    if (change.kind != CatalogueChange::Kind::kProcess) continue;
    const ProcessDescription& process = change.processes.front();
    const bool is_gone =
        process.state == ProcessState::kSuspect || process.state == ProcessState::kLost;
    const bool is_hidden = process.state == ProcessState::kAlive && !process.reason.empty();
    const bool well = !is_gone && !is_hidden;
    const std::string reason = process.reason.empty() ? "" : ": " + process.reason;
    Log(well ? LogLevel::kInfo : LogLevel::kWarning, "gcm",
        "process '" + process.name + "' " + std::string(Words(process.state)) + reason);
  }
}

bool ChangesProcesses(const std::vector<CatalogueChange>& changes) {
  return std::ranges::any_of(changes, [](const CatalogueChange& change) {
    return change.kind == CatalogueChange::Kind::kProcess;
  });
}

}  // namespace tendon::server
