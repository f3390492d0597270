#pragma once

#include <program/network_options.h>
#include <tendon/gcm/client.h>

#include <chrono>
#include <string>

namespace console {

/// The condition under which text is coloured. kAuto: on a terminal, unless $NO_COLOR is set.
enum class ColorChoice { kAuto, kAlways, kNever };

/// The messages that are printed in addition to the results.
enum class Verbosity { kNormal, kQuiet, kVerbose };

/// The settings that every verb shares, from the command line.
struct Settings {
  std::string gcm;
  program::NetworkOptions network;
  std::chrono::milliseconds timeout = tendon::GcmClient::Options().timeout;
  bool json = false;
  bool read_only = false;
  bool titles = true;  ///< print the titles of tables on a terminal
  Verbosity verbosity = Verbosity::kNormal;
  ColorChoice color = ColorChoice::kAuto;
  bool in_session = false;  ///< true for a line of a session; its paths may begin with / or ..
  std::string at = {};      ///< the path to which relative paths are relative; if empty, the top
  int scripts = 0;          ///< nesting depth of the scripts that run this line; 0 if none
};

}  // namespace console
