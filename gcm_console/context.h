#pragma once

#include <gcm_console/command_line/settings.h>
#include <gcm_console/command_line/shell_session.h>
#include <gcm_console/output/table.h>
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

/// The streams of a command line.
struct Streams {
  std::ostream& out;
  std::ostream& err;
  int columns = 0;                            ///< the width of the terminal behind `out`, 0 if none
  MakeLineReader make_line_reader = nullptr;  ///< set if the input is a terminal
  bool has_input = true;                      ///< false in a window: nothing can be piped in
};

/// True if the terminal cannot move the cursor and can only append lines.
[[nodiscard]] bool IsDumbTerminal();

/// The error for a verb that reads its input, if it is used in a window.
[[nodiscard]] tendon::Error NoInput(const std::string& verb);

/// The environment of a running verb: its output, and its client of the GCM.
class Context {
 public:
  /// With a session, the verb uses the session's link.
  Context(Settings settings, std::string verb, const Streams& streams,
          ShellSession* session = nullptr);

  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const std::string& verb() const { return verb_; }
  [[nodiscard]] std::ostream& out() const { return streams_.out; }
  /// For messages that are not results.
  [[nodiscard]] std::ostream& err() { return is_quiet() ? nowhere_ : streams_.err; }
  /// The width of the terminal behind out(), 0 if it is not a terminal.
  [[nodiscard]] int columns() const { return streams_.columns; }
  [[nodiscard]] const Streams& streams() const { return streams_; }
  /// True if the output is a terminal that can redraw a picture.
  [[nodiscard]] bool has_screen() const;
  /// Null outside a session.
  [[nodiscard]] ShellSession* session() const { return session_; }
  /// How tables are printed.
  [[nodiscard]] Layout layout() const;

  /// Sends a request through the client and waits for the answer, 500 ms longer than the client
  /// does, because the client's own time-out error gives the best reason. `start(client, handler)`
  /// calls one of the client's functions, which may take `times` times the time-out.
  template <typename T, typename Start>
  tendon::Result<T> Ask(Start start, int times = 1) {
    constexpr std::chrono::milliseconds kLonger(500);
    const auto client = Client();
    if (!client) return client.error();
    return tendon::Wait<T>(times * settings_.timeout + kLonger,
                           [&](auto handler) { start(**client, std::move(handler)); });
  }

  /// Returns a client that has received the catalogue; the first call creates it, with `listener`.
  tendon::Result<tendon::GcmClient*> Client(
      std::shared_ptr<tendon::GcmListener> listener = nullptr);

  /// Prints that the GCM was lost and is back.
  void PrintGcmReturn();

  void Print(const Table& table) const { table.Print(out(), layout()); }
  /// Prints one JSON document, with "schema": 1 as its first key.
  void PrintJson(const nlohmann::ordered_json& content) const;
  /// The same in one line, for a stream of documents.
  void PrintJsonLine(const nlohmann::ordered_json& content) const;

 private:
  [[nodiscard]] bool is_quiet() const { return settings_.verbosity == Verbosity::kQuiet; }

  Settings settings_;
  std::string verb_;
  Streams streams_;
  ShellSession* session_;
  std::ostream nowhere_{nullptr};
  std::shared_ptr<tendon::GcmClient> client_;
};

}  // namespace console
