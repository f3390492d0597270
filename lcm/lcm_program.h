#pragma once

#include <program/exit_code.h>
#include <program/network_options.h>
#include <tendon/base/result.h>
#include <tendon/gcm/system_file.h>
#include <tendon/process/process.h>

#include <chrono>
#include <string>

namespace lcm {

/// The options of the command line.
struct Options {
  std::string name;
  std::string gcm;
  std::string system;  ///< a system file, or empty to start without components
  std::string listen = "127.0.0.1:0";
  std::string advertise;
  std::chrono::milliseconds timeout{3000};  ///< time limit for finding and joining the GCM
  tendon::HistoryOptions history;
  program::NetworkOptions network;
};

/// Runs a process until it is asked to terminate. Loads the plug-ins that the system file names,
/// creates the components, joins the GCM, makes the connections and starts everything. Returns the
/// exit code. An error is reported as one sentence on stderr, and no partial state remains.
program::ExitCode Run(const Options& options);

}  // namespace lcm
