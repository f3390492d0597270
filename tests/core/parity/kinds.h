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

/// Every kind of component: its cycles differ in the thread that makes them.
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
/// All kinds but kThreadless.
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
  /// Makes a cycle, for kinds that run in the calling thread.
  virtual void Drive() {}

  std::function<void()> job;  // set before the command Step
  std::atomic<std::uint64_t> runs = 0;
  std::atomic<std::thread::id> run_thread;  // of the last cycle
  std::atomic<bool> throws_in_run = false;

 protected:
  void AddDesk(tendon::ProvidedInterface& desk) { desk.AddCommandVoid(&Part::Step, this, "Step"); }
  void NoteRun();

 private:
  void Step() {
    const std::function<void()> now = job;  // the next may be set while this one runs
    now();
  }
};

/// The server's part: provides an interface for each payload, and messages.
class ServerPart : public Part {
 public:
  ServerPorts ports;
  std::unique_ptr<tendon::StatusMessages> messages;
  /// The history of the ports' goals, and of a number and its double. The test makes its rows.
  tendon::StateTable* history = nullptr;
  int number = 0;
  int doubled = 0;
  /// The table with the ports' columns.
  tendon::StateTable* table = nullptr;

  /// Makes a row of the values written so far, for kinds without cycles. Called in the server's
  /// thread.
  virtual void Publish() {}

 protected:
  void FillHistory(tendon::StateTable& history_table);
};

/// Requires an interface for each payload, and the messages; may also require one that stays
/// unconnected.
class ClientPart : public Part {
 public:
  ClientPorts ports;
  std::vector<std::string> heard;  // messages, in the client's thread
  tendon::VoidFunction optional;

 protected:
  void AddMessages(tendon::RequiredInterface& interface);

 private:
  void OnStatus(const std::string& text) { heard.push_back("status: " + text); }
  void OnWarning(const std::string& text) { heard.push_back("warning: " + text); }
  void OnError(const std::string& text) { heard.push_back("error: " + text); }
};

/// Adds a component of this kind, made from the same source as all others, and for kFollower the
/// task it runs after.
ServerPart& AddServer(tendon::LocalManager& manager, Kind kind);
ClientPart& AddClient(tendon::LocalManager& manager, Kind kind);

}  // namespace tendon_test
