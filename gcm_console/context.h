#pragma once

#include <program/exit_code.h>
#include <program/network_options.h>
#include <tendon/base/result.h>
#include <tendon/gcm/client.h>

#include <chrono>
#include <iosfwd>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace console {

/// What holds for every verb, from the command line.
struct Settings {
  std::string gcm;
  program::NetworkOptions network;
  std::chrono::milliseconds timeout = tendon::GcmClient::Options().timeout;
  bool json = false;
  bool read_only = false;
};

/// Where a verb's output goes, and what it asks the GCM through.
class Context {
 public:
  Context(Settings settings, std::string verb, std::ostream& out, std::ostream& err, int columns);

  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] std::ostream& out() const { return out_; }
  /// For remarks that are no result.
  [[nodiscard]] std::ostream& err() const { return err_; }
  /// The width of the terminal that out() is, 0 where it is none.
  [[nodiscard]] int columns() const { return columns_; }

  /// Asks the client and waits for its answer, a little longer than the client: it gives up after
  /// the time-out by itself, and knows best why. `start(client, handler)` calls one of its
  /// functions, which may take that time `times` times.
  template <typename T, typename Start>
  tendon::Result<T> Ask(Start start, int times = 1) {
    constexpr std::chrono::milliseconds kLonger(500);
    const auto client = Client();
    if (!client) return client.error();
    return tendon::Wait<T>(times * settings_.timeout + kLonger,
                           [&](auto handler) { start(**client, std::move(handler)); });
  }

  /// A client that has seen the catalogue; made once, with the listener of the first call.
  tendon::Result<tendon::GcmClient*> Client(
      std::shared_ptr<tendon::GcmListener> listener = nullptr);

  /// One JSON document, with "schema": 1 as its first key.
  void PrintJson(const nlohmann::ordered_json& content) const;

 private:
  Settings settings_;
  std::string verb_;
  std::ostream& out_;
  std::ostream& err_;
  int columns_;
  std::unique_ptr<tendon::GcmClient> client_;
};

}  // namespace console
