#pragma once

#include <program/network_options.h>
#include <tendon/gcm/client.h>

#include <chrono>
#include <string>

namespace console {

/// When to colour text. `kAuto`: on a terminal, unless $NO_COLOR is set.
enum class ColorChoice { kAuto, kAlways, kNever };

/// How many messages to print beside the results.
enum class Verbosity { kNormal, kQuiet, kVerbose };

/// The settings that every verb shares, from the command line.
struct Settings {
  std::string gcm;
  program::NetworkOptions network;
  std::chrono::milliseconds timeout = tendon::GcmClient::Options().timeout;
  bool json = false;
  bool read_only = false;
  bool titles = true;  ///< of tables on a terminal
  Verbosity verbosity = Verbosity::kNormal;
  ColorChoice color = ColorChoice::kAuto;
  bool in_session = false;  ///< a line of a session, whose paths may begin with / or ..
  std::string at = {};      ///< where relative paths begin; empty: at the top
  int scripts = 0;          ///< the nesting depth of scripts that run this line
};

}  // namespace console
