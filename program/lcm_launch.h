#pragma once

#include <program/network_options.h>
#include <tendon/gcm/supervisor/launch.h>

namespace program {

/// Makes a GCM in this program start processes with the `lcm` in the same folder and the same
/// network options. Under TLS a process uses the certificate of its name, PROCESS.crt, from the
/// folder of the program's own.
tendon::Launch LcmLaunch(const NetworkOptions& options);

}  // namespace program
