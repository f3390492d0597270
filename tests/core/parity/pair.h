#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <thread>
#include <tuple>
#include <type_traits>
#include <vector>

#include "core/parity/kinds.h"
#include "support/wait.h"

namespace tendon_test {

/// The longest time that a call of a test waits; it only limits a failing test.
inline constexpr std::chrono::seconds kLong(60);

/// The managers of a server and of a client. They are in two processes if the server's process has
/// a name.
class Ground {
 public:
  virtual ~Ground() = default;
  [[nodiscard]] virtual tendon::LocalManager& server() = 0;
  [[nodiscard]] virtual tendon::LocalManager& client() = 0;
  [[nodiscard]] virtual std::string server_process() const { return {}; }
  /// Called after a pair has ended. Removes its components from objects that later pairs use again.
  virtual void Clear() {}
};

/// One process, or two processes on a kind of network.
struct Place {
  std::string name;
  std::function<std::unique_ptr<Ground>()> make;
};
inline void PrintTo(const Place& place, std::ostream* out) { *out << place.name; }
[[nodiscard]] Place OneProcess();

/// A server and a client that are connected and running. A test accesses a component only by jobs.
/// The component's thread executes a job as a command.
class Pair {
 public:
  Pair(Kind client_kind, Kind server_kind, const Place& place = OneProcess());
  ~Pair();
  Pair(const Pair&) = delete;
  Pair& operator=(const Pair&) = delete;

 private:
  const std::unique_ptr<Ground> ground_;

 public:
  tendon::LocalManager& manager;  ///< the manager of the server; in one process, also of the client
  ServerPart& server;
  ClientPart& client;

  /// Calls `body(port)` for the port of each payload, in the server's thread, after all waiting
  /// calls. Returns after the last call of `body`.
  template <typename Body>
  void InServer(Body body) {
    OnceInServer([&] { ForEachPort(server.ports, body); });
  }
  template <typename Body>
  void InClient(Body body) {
    OnceInClient([&] { ForEachPort(client.ports, body); });
  }
  /// Calls `job` once in the server's thread, after all waiting calls. Returns after the call.
  void OnceInServer(const std::function<void()>& job) { Execute(step_server_, server, job); }
  void OnceInClient(const std::function<void()>& job) { Execute(step_client_, client, job); }

  /// Blocks the thread of a task in a command until Release().
  void HoldServer() { Hold(step_server_, server); }
  void HoldClient() { Hold(step_client_, client); }
  void Release();

  /// Returns true if there is a network between server and client.
  [[nodiscard]] bool is_remote() const { return !ground_->server_process().empty(); }
  /// Returns the status of a queued call. A server without a thread in the same process executes
  /// the call at once.
  [[nodiscard]] tendon::Status queued() const {
    return has_thread_ || is_remote() ? tendon::Status::kQueued : tendon::Status::kDone;
  }
  /// Returns the status of a direct call.
  [[nodiscard]] tendon::Status direct() const {
    return is_remote() ? tendon::Status::kQueued : tendon::Status::kDone;
  }
  /// Over a network, waits until all earlier calls and events were executed, or wait in their
  /// mailbox at the other end. Executes `take`, and raises `settled`.
  void Deliver();
  /// Checks the thread in which direct code runs: the thread of the caller. For a caller in another
  /// process, it is a thread that belongs to neither component.
  void ExpectInThreadOf(std::thread::id caller, std::thread::id thread) const;

  /// Connects all ports, by their names.
  void Connect();
  /// Disconnects all ports. Returns false if this took so long that accepted calls may have been
  /// dropped.
  bool Disconnect();
  /// Ends the thread of the test that makes the component's cycles, and removes the component.
  void Remove(Part& part);

 private:
  [[nodiscard]] tendon::InterfaceName ServerInterface(const std::string& name) const;
  void AwaitConnections();
  static void Execute(tendon::VoidFunction& step, Part& part, const std::function<void()>& job);
  void Hold(tendon::VoidFunction& step, Part& part);

  bool has_thread_;
  tendon::VoidFunction& step_server_;
  tendon::VoidFunction& step_client_;
  std::atomic<bool> is_held_ = false;
  // The threads that run the cycles of components without their own thread.
  std::map<const Part*, std::jthread> lent_;
};

/// Every kind of client with every kind of server.
using Kinds = std::tuple<Kind, Kind>;
struct AnyPair : testing::TestWithParam<Kinds> {
  Pair pair{std::get<0>(GetParam()), std::get<1>(GetParam())};
};
inline auto AllPairs() {
  return testing::Combine(testing::ValuesIn(AllKinds()), testing::ValuesIn(AllKinds()));
}
inline std::string NameOfPair(const testing::TestParamInfo<Kinds>& info) {
  return std::string(NameOf(std::get<0>(info.param))) + "CallsA" +
         std::string(NameOf(std::get<1>(info.param)));
}

/// Every kind of client with every kind of server, in every place.
using PlacedKinds = std::tuple<Kind, Kind, Place>;
struct AnyPlacedPair : testing::TestWithParam<PlacedKinds> {
  Pair pair{std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam())};
};
inline auto AllPairsInOneProcess() {
  return testing::Combine(testing::ValuesIn(AllKinds()), testing::ValuesIn(AllKinds()),
                          testing::Values(OneProcess()));
}
inline std::string NameOfPlacedPair(const testing::TestParamInfo<PlacedKinds>& info) {
  return std::string(NameOf(std::get<0>(info.param))) + "CallsA" +
         std::string(NameOf(std::get<1>(info.param))) + std::get<2>(info.param).name;
}

/// Every kind of server with a client without a thread. The test's thread makes the client's calls.
struct AnyServer : testing::TestWithParam<Kind> {
  Pair pair{Kind::kThreadless, GetParam()};
};
inline std::string NameOfKind(const testing::TestParamInfo<Kind>& info) {
  return std::string(NameOf(info.param));
}

/// The payload of a port, or of `decltype(port)`.
template <typename Port>
using PayloadIn = typename std::remove_reference_t<Port>::Value;

}  // namespace tendon_test
