#pragma once

#include <program/network_options.h>
#include <tendon/gcm/client.h>

#include <chrono>
#include <string>

namespace console {

/// When text is coloured: `kAuto` is on a terminal, unless the user says otherwise by $NO_COLOR.
enum class ColorChoice { kAuto, kAlways, kNever };

/// How much is remarked beside the results.
enum class Remarks { kUsual, kNone, kMore };

/// What holds for every verb, from the command line.
struct Settings {
  std::string gcm;
  program::NetworkOptions network;
  std::chrono::milliseconds timeout = tendon::GcmClient::Options().timeout;
  bool json = false;
  bool read_only = false;
  bool titles = true;  ///< of tables on a terminal
  Remarks remarks = Remarks::kUsual;
  ColorChoice color = ColorChoice::kAuto;
  bool in_session = false;  ///< one line of several, whose paths may begin with / or ..
  std::string at = {};      ///< where relative paths begin; empty: at the top
  int scripts = 0;          ///< that run each other, down to this line
};

}  // namespace console
