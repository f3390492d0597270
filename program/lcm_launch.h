#pragma once

#include <program/network_options.h>
#include <tendon/gcm/supervisor/launch.h>

namespace program {

/// How a GCM in this program starts processes: the `lcm` that lies beside it, which talks as the
/// program does. Under TLS a process shows the certificate of its name, PROCESS.crt in the folder
/// of the program's own.
tendon::Launch LcmLaunch(const NetworkOptions& options);

}  // namespace program
