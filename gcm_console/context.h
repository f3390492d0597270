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
#include <utility>

namespace console {

/// The streams of a command line.
struct Streams {
  std::ostream& out;
  std::ostream& err;
  int columns = 0;  ///< width of the terminal behind `out`; 0 if there is none
  MakeLineReader make_line_reader = nullptr;  ///< not null if the input is a terminal
  bool has_input = true;                      ///< false in a window, which has no standard input
};

/// Returns true if the terminal cannot move the cursor, so that lines can only be appended.
[[nodiscard]] bool IsDumbTerminal();

/// Returns the error for a verb that reads its input but is used in a window.
[[nodiscard]] tendon::Error NoInput(const std::string& verb);

/// The output of a running verb, and its client of the GCM.
class Context {
 public:
  /// Creates the context of a verb. If `session` is not null, the verb uses the link of the
  /// session.
  Context(Settings settings, std::string verb, const Streams& streams,
          ShellSession* session = nullptr);

  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const std::string& verb() const { return verb_; }
  [[nodiscard]] std::ostream& out() const { return streams_.out; }
  /// The stream for messages that are not results.
  [[nodiscard]] std::ostream& err() { return is_quiet() ? nowhere_ : streams_.err; }
  /// The width of the terminal behind out(); 0 if there is none.
  [[nodiscard]] int columns() const { return streams_.columns; }
  [[nodiscard]] const Streams& streams() const { return streams_; }
  /// Returns true if out() is a terminal that can redraw a picture.
  [[nodiscard]] bool has_screen() const;
  /// The session; null if there is none.
  [[nodiscard]] ShellSession* session() const { return session_; }
  /// Returns how tables are printed.
  [[nodiscard]] TableLayout layout() const;

  /// Sends a request through the client, and waits for the reply. `start(client, handler)` calls
  /// one of the client's functions, which may take `times` times the time-out. Waits 500 ms longer
  /// than the client, because the client's own time-out error gives the best reason.
  template <typename T, typename Start>
  tendon::Result<T> Ask(Start start, int times = 1) {
    constexpr std::chrono::milliseconds kLonger(500);
    const auto client = Client();
    if (!client) return client.error();
    return tendon::Wait<T>(times * settings_.timeout + kLonger,
                           [&](auto handler) { start(**client, std::move(handler)); });
  }

  /// Returns a client that has received the catalogue. The first call creates the client, with this
  /// `listener`.
  tendon::Result<tendon::GcmClient*> Client(
      std::shared_ptr<tendon::GcmListener> listener = nullptr);

  /// Prints that the GCM was lost and is available again.
  void PrintGcmReturn();

  void Print(const Table& table) const { table.Print(out(), layout()); }
  /// Prints one JSON document; its first key is "schema": 1.
  void PrintJson(const nlohmann::ordered_json& content) const;
  /// Prints a JSON document in one line, for a stream of documents.
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
