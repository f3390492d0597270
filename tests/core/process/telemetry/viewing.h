#pragma once

#include <tendon/base/os/process.h>
#include <tendon/process/telemetry/make_telemetry_client.h>

#include <memory>
#include <string>

#include "support/network_test.h"

/// Processes with their GCM, and viewers that find these processes.
class ViewingTest : public NetworkTest {
 protected:
  /// Makes a separate viewer.
  std::unique_ptr<tendon::TelemetryClient> View() {
    return tendon::MakeTelemetryClient(
        NewMiddleware(),
        [this](const std::string& process) -> tendon::Result<std::string> {
          const tendon::Catalogue catalogue = gcm().catalogue();
          const auto* entry = catalogue.FindProcess(process);
          if (entry != nullptr && entry->process.state == tendon::ProcessState::kAlive) {
            return entry->process.address;
          }
          return tendon::Error{tendon::ErrorCode::kNotFound,
                               "process '" + process + "' is not available"};
        },
        {.instance = tendon::os::RandomNumber(),
         .name = "viewer",
         .cookie = *tendon::LoopbackCookie()});
  }
};
