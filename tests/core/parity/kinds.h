#pragma once

#include <tendon/interface/status_messages.h>
#include <tendon/manager/local_manager.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "core/parity/ports.h"

namespace tendon_test {

/// Every kind of component. The kinds differ in the thread that runs their cycles.
enum class Kind {
  kPeriodic,
  kContinuous,
  kSignal,
  kCallback,    ///< driven by a thread of the test
  kMain,        ///< in a thread of the test
  kFollower,    ///< runs after a periodic task, in its thread
  kThreadless,  ///< runs in its callers' threads
};
[[nodiscard]] std::string_view NameOf(Kind kind);
[[nodiscard]] std::vector<Kind> AllKinds();
/// Returns all kinds except kThreadless.
[[nodiscard]] std::vector<Kind> TaskKinds();

/// The common part of servers and clients of any kind: their interface `Desk` executes jobs of the
/// test in the component's thread.
class Part {
 public:
  Part() = default;
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;
  virtual ~Part() = default;

  [[nodiscard]] virtual tendon::Component& component() = 0;
  /// Runs a cycle, for kinds that run in the calling thread.
  virtual void Drive() {}

  std::function<void()> job;  // set before the command Step is called
  std::atomic<std::uint64_t> runs = 0;
  std::atomic<std::thread::id> run_thread;  // the thread of the last cycle
  std::atomic<bool> throws_in_run = false;

 protected:
  void AddDesk(tendon::ProvidedInterface& desk) { desk.AddCommandVoid(&Part::Step, this, "Step"); }
  void NoteRun();

 private:
  void Step() {
    // A copy, because the test may set the next job while this one runs.
    const std::function<void()> now = job;
    now();
  }
};

/// The server's part: provides an interface for each payload, and messages.
class ServerPart : public Part {
 public:
  ServerPorts ports;
  std::unique_ptr<tendon::StatusMessages> messages;
  /// A history of the goals of all ports, and of a number and twice that number. The test writes
  /// its rows.
  tendon::StateTable* history = nullptr;
  int number = 0;
  int doubled = 0;
  /// The table with the ports' columns.
  tendon::StateTable* table = nullptr;

  /// Writes a row with the present values, for kinds without cycles. Called in the server's thread.
  virtual void Publish() {}

 protected:
  void FillHistory(tendon::StateTable& history_table);
};

/// The client's part: requires an interface for each payload, and the messages. May also require an
/// interface that stays unconnected.
class ClientPart : public Part {
 public:
  ClientPorts ports;
  std::vector<std::string> heard;  // the received messages; used in the client's thread
  tendon::VoidFunction optional;

 protected:
  void AddMessages(tendon::RequiredInterface& interface);

 private:
  void OnStatus(const std::string& text) { heard.push_back("status: " + text); }
  void OnWarning(const std::string& text) { heard.push_back("warning: " + text); }
  void OnError(const std::string& text) { heard.push_back("error: " + text); }
};

/// Adds a server of this kind. All kinds use the same source. For kFollower, also adds the task
/// after which the server runs.
ServerPart& AddServer(tendon::LocalManager& manager, Kind kind);
ClientPart& AddClient(tendon::LocalManager& manager, Kind kind);

}  // namespace tendon_test
