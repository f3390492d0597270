#pragma once

#include <program/network_options.h>
#include <tendon/gcm/supervisor/launch_options.h>

namespace program {

/// Returns options for a GCM in this program. With them, the GCM starts processes with the `lcm` in
/// the same folder and with the same network options. With TLS, a process uses the certificate
/// PROCESS.crt in the folder of the program's own certificate.
tendon::LaunchOptions LcmLaunchOptions(const NetworkOptions& options);

}  // namespace program
