#pragma once

#include <tendon/base/error.h>

#include <string>

namespace tendon::test {

/// Returns the message of the ConfigurationError that `action` throws; empty if it throws none.
template <typename Action>
std::string Refusal(Action action) {
  try {
    action();
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "";
}

}  // namespace tendon::test
