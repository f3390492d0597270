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
  std::chrono::milliseconds timeout{3000};  ///< for finding the GCM and joining it
  program::NetworkOptions network;
};

/// Runs a process until it is told to stop: loads its plug-ins from the system file, creates its
/// components, joins the GCM, makes its connections and starts everything. Returns the exit code.
/// An error is one sentence on stderr, and nothing is left half done.
program::ExitCode Run(const Options& options);

}  // namespace lcm
