#pragma once

#include <gcm_console/line/session.h>
#include <gcm_console/line/settings.h>
#include <gcm_console/report.h>
#include <gcm_console/shell/line_reader.h>
#include <program/exit_code.h>
#include <tendon/base/result.h>
#include <tendon/gcm/client.h>

#include <chrono>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>

namespace console {

/// Where the output of a command line goes.
struct Streams {
  std::ostream& out;
  std::ostream& err;
  int columns = 0;                            ///< of the terminal that `out` is, 0 where it is none
  MakeLineReader make_line_reader = nullptr;  ///< where a person sits at a terminal
  bool has_input = true;                      ///< false in a window, where nothing can be piped in
};

/// Whether the terminal can do no more than print one line below another.
[[nodiscard]] bool IsDumbTerminal();

/// Why a verb that reads its input cannot do so in a window.
[[nodiscard]] tendon::Error NoInput(const std::string& verb);

/// Where a verb's output goes, and what it asks the GCM through.
class Context {
 public:
  /// With a session, the verb uses its link.
  Context(Settings settings, std::string verb, const Streams& streams, Session* session = nullptr);

  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const std::string& verb() const { return verb_; }
  [[nodiscard]] std::ostream& out() const { return streams_.out; }
  /// For remarks that are no result.
  [[nodiscard]] std::ostream& err() { return is_quiet() ? nowhere_ : streams_.err; }
  /// The width of the terminal that out() is, 0 where it is none.
  [[nodiscard]] int columns() const { return streams_.columns; }
  [[nodiscard]] const Streams& streams() const { return streams_; }
  /// Whether a person sits at a terminal on which a picture can be drawn anew.
  [[nodiscard]] bool has_screen() const;
  /// Null where the line stands alone.
  [[nodiscard]] Session* session() const { return session_; }
  /// How tables are printed.
  [[nodiscard]] Layout layout() const;

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

  void Print(const Table& table) const { table.Print(out(), layout()); }
  /// One JSON document, with "schema": 1 as its first key.
  void PrintJson(const nlohmann::ordered_json& content) const;
  /// The same in one line, as one of many.
  void PrintJsonLine(const nlohmann::ordered_json& content) const;

 private:
  [[nodiscard]] bool is_quiet() const { return settings_.remarks == Remarks::kNone; }

  Settings settings_;
  std::string verb_;
  Streams streams_;
  Session* session_;
  std::ostream nowhere_{nullptr};
  std::shared_ptr<tendon::GcmClient> client_;
};

}  // namespace console
