#pragma once

#include <tendon/base/os/process.h>

#include <string>

/// "bin/gcm": where that is in the build this test program lies in. Not told by the compiler:
/// presets share what it makes.
inline std::string Built(const std::string& place) {
  return tendon::os::ProgramFolder().parent_path() / place;
}
