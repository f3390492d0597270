#pragma once

#include <tendon/interface/event_waiter.h>
#include <tendon/interface/provided_interface.h>
#include <tendon/interface/required_interface.h>
#include <tendon/state/state_table.h>

#include <array>
#include <atomic>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "core/parity/payloads.h"

namespace tendon_test {

/// The server's members for one payload: every kind of command, the events, and a column. Members
/// that are not atomic are used only in the server's thread.
template <tendon::Payload P>
class ServerPort {
 public:
  using Value = P;

  /// Called in the server's constructor; `name` is the name of the column.
  void AddTo(tendon::ProvidedInterface& interface, tendon::StateTable& table,
             const std::string& name);
  void AddGoalTo(tendon::StateTable& table, const std::string& name) const;

  P goal{};                 // recorded in a column
  std::vector<P> received;  // arguments of the write command, in order
  std::vector<P> kept;      // arguments of the write command that keeps only the latest call
  std::vector<Filtered> filtered;
  int resets = 0;
  std::thread::id thread;                // the thread of the last queued command
  std::thread::id direct_thread;         // the thread of the last direct command
  std::atomic<bool> is_blocked = false;  // true while the command Block waits
  std::atomic<bool> blocks = true;
  std::atomic<int> executed = 0;  // number of queued commands that have ended

  tendon::VoidEvent done;
  tendon::WriteEvent<P> reached;
  tendon::WriteEvent<P> passed;
  tendon::WriteEvent<P> settled;
  tendon::Offer* write = nullptr;  // the write command; a test can switch it off

 private:
  void Reset();
  void Write(const P& value);
  void Keep(const P& value);
  void WriteFiltered(const Filtered& value);
  static void Filter(const P& value, Filtered& filtered);
  void Take(P& value);
  void Swap(const P& value, P& last);
  static void IsAt(const P& row, const P& question, bool& result);
  void WriteDirect(const P& value);
  void Count(std::int32_t& count) const;
  void Block();
  void Note();
};

/// The client's members: one function or handler for each member of a ServerPort.
template <tendon::Payload P>
class ClientPort {
 public:
  using Value = P;

  void AddTo(tendon::RequiredInterface& interface);

  tendon::VoidFunction reset;
  tendon::WriteFunction<P> write;
  tendon::WriteFunction<P> keep;
  tendon::WriteFunction<P> write_filtered;
  tendon::WriteFunction<P> write_direct;
  tendon::ReadFunction<P> read;
  tendon::ReadFunction<std::int32_t> count;
  tendon::QualifiedReadFunction<P, bool> is_at;
  tendon::VoidReturnFunction<P> take;
  tendon::WriteReturnFunction<P, P> swap;
  tendon::VoidFunction block;
  tendon::VoidFunction missing;  // an optional function whose command is not offered

  // The following members are used in the client's thread.
  int dones = 0;
  std::vector<P> reached;
  std::thread::id thread;  // the thread of the last queued handler
  int strange = 0;         // calls of handlers for events that are not offered
  // The following members are used in the server's thread.
  std::vector<P> passed;
  std::thread::id direct_thread;

  tendon::EventWaiter<P> settled;

 private:
  void OnDone();
  void OnReached(const P& value);
  void OnPassed(const P& value);
  void OnStrange();
};

template <typename... P>
using ServerPortsOf = std::tuple<ServerPort<P>...>;
template <typename... P>
using ClientPortsOf = std::tuple<ClientPort<P>...>;
using ServerPorts = ForPayloads<ServerPortsOf>;
using ClientPorts = ForPayloads<ClientPortsOf>;

/// The names of the interfaces and columns, in the order of the payloads.
inline constexpr std::array kPortNames = {"Joints",  "Vector3", "Pose", "Text",
                                          "Numbers", "VectorX", "Scan"};

/// Calls `body(port)` for each port.
template <typename Ports, typename Body>
void ForEachPort(Ports& ports, Body body) {
  std::apply([&body](auto&... port) { (body(port), ...); }, ports);
}

}  // namespace tendon_test
