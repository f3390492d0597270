#include "core/parity/ports.h"

#include <functional>

namespace tendon_test {
namespace {

std::uint64_t ThisThread() { return std::hash<std::thread::id>()(std::this_thread::get_id()); }

}  // namespace

template <tendon::Payload P>
void ServerPort<P>::AddTo(tendon::ProvidedInterface& interface, tendon::StateTable& table,
                          const std::string& name) {
  AddGoalTo(table, name);
  interface.AddCommandVoid(&ServerPort::Reset, this, "Reset");
  write = &interface.AddCommandWrite(&ServerPort::Write, this, "Write");
  interface.AddCommandWrite(&ServerPort::Keep, this, "Keep")
      .SetOverflow(tendon::Overflow::kLatestOnly);
  interface.AddCommandFilteredWrite(&ServerPort::Filter, &ServerPort::WriteFiltered, this,
                                    "WriteFiltered");
  interface.AddCommandWrite(&ServerPort::WriteDirect, this, "WriteDirect", tendon::kThreadSafe);
  interface.AddCommandReadState(table, goal, "Read");
  interface.AddCommandRead(&ServerPort::Count, this, "Count", tendon::kThreadSafe);
  interface.AddCommandQualifiedRead(table, goal, &ServerPort::IsAt, "IsAt");
  interface.AddCommandVoidReturn(&ServerPort::Take, this, "Take");
  interface.AddCommandWriteReturn(&ServerPort::Swap, this, "Swap");
  interface.AddCommandVoid(&ServerPort::Block, this, "Block");
  interface.AddEvent(done, "Done");
  interface.AddEvent(reached, "Reached");
  interface.AddEvent(passed, "Passed");
  interface.AddEvent(settled, "Settled");
}

template <tendon::Payload P>
void ServerPort<P>::AddGoalTo(tendon::StateTable& table, const std::string& name) const {
  if constexpr (tendon::FixedPayload<P>) {
    table.Add(goal, name);
  } else {
    table.Add(goal, name, kColumnCapacity);
  }
}

template <tendon::Payload P>
void ServerPort<P>::Reset() {
  ++resets;
  Note();
}

template <tendon::Payload P>
void ServerPort<P>::Write(const P& value) {
  received.push_back(value);
  Note();
}

template <tendon::Payload P>
void ServerPort<P>::Keep(const P& value) {
  kept.push_back(value);
  Note();
}

template <tendon::Payload P>
void ServerPort<P>::WriteFiltered(const Filtered& value) {
  filtered.push_back(value);
  Note();
}

template <tendon::Payload P>
void ServerPort<P>::Filter(const P& value, Filtered& filtered) {
  filtered = {.bytes = BytesOf(value).size(), .thread = ThisThread()};
}

template <tendon::Payload P>
void ServerPort<P>::Take(P& value) {
  value = goal;
  Note();
}

template <tendon::Payload P>
void ServerPort<P>::Swap(const P& value, P& last) {
  last = goal;
  goal = value;
  Note();
}

template <tendon::Payload P>
void ServerPort<P>::IsAt(const P& row, const P& question, bool& result) {
  result = BytesOf(row) == BytesOf(question);
}

template <tendon::Payload P>
void ServerPort<P>::WriteDirect(const P& /*value*/) {
  direct_thread = std::this_thread::get_id();
}

template <tendon::Payload P>
void ServerPort<P>::Count(std::int32_t& count) const {
  count = executed;
}

template <tendon::Payload P>
void ServerPort<P>::Block() {
  is_blocked = true;
  while (blocks) std::this_thread::yield();
  is_blocked = false;
  Note();
}

template <tendon::Payload P>
void ServerPort<P>::Note() {
  thread = std::this_thread::get_id();
  ++executed;
}

template <tendon::Payload P>
void ClientPort<P>::AddTo(tendon::RequiredInterface& interface) {
  interface.AddFunction(reset, "Reset");
  interface.AddFunction(write, "Write");
  interface.AddFunction(keep, "Keep");
  interface.AddFunction(write_filtered, "WriteFiltered");
  interface.AddFunction(write_direct, "WriteDirect");
  interface.AddFunction(read, "Read");
  interface.AddFunction(count, "Count");
  interface.AddFunction(is_at, "IsAt");
  interface.AddFunction(take, "Take");
  interface.AddFunction(swap, "Swap");
  interface.AddFunction(block, "Block");
  interface.AddFunction(missing, "Missing", tendon::Need::kOptional);
  interface.AddEventHandlerVoid(&ClientPort::OnDone, this, "Done");
  interface.AddEventHandlerWrite(&ClientPort::OnReached, this, "Reached");
  interface.AddEventHandlerWrite(&ClientPort::OnPassed, this, "Passed", tendon::kThreadSafe);
  interface.AddEventHandlerVoid(&ClientPort::OnStrange, this, "Strange", tendon::Need::kOptional);
  interface.AddEventWaiter(settled, "Settled");
}

template <tendon::Payload P>
void ClientPort<P>::OnDone() {
  ++dones;
  thread = std::this_thread::get_id();
}

template <tendon::Payload P>
void ClientPort<P>::OnReached(const P& value) {
  reached.push_back(value);
  thread = std::this_thread::get_id();
}

template <tendon::Payload P>
void ClientPort<P>::OnPassed(const P& value) {
  passed.push_back(value);
  direct_thread = std::this_thread::get_id();
}

template <tendon::Payload P>
void ClientPort<P>::OnStrange() {
  ++strange;
}

template class ServerPort<Joints>;
template class ServerPort<Eigen::Vector3d>;
template class ServerPort<Pose>;
template class ServerPort<std::string>;
template class ServerPort<std::vector<double>>;
template class ServerPort<Eigen::VectorXd>;
template class ServerPort<Scan>;
template class ClientPort<Joints>;
template class ClientPort<Eigen::Vector3d>;
template class ClientPort<Pose>;
template class ClientPort<std::string>;
template class ClientPort<std::vector<double>>;
template class ClientPort<Eigen::VectorXd>;
template class ClientPort<Scan>;

}  // namespace tendon_test
