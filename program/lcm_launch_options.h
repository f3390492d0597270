#pragma once

#include <program/network_options.h>
#include <tendon/gcm/supervisor/launch_options.h>

namespace program {

/// Options for a GCM in this program, so that it starts processes with the `lcm` in the same folder
/// and the same network options. Under TLS, a process uses the certificate PROCESS.crt in the
/// folder of the program's own certificate.
tendon::LaunchOptions LcmLaunchOptions(const NetworkOptions& options);

}  // namespace program
