#include <tendon/ice/bounded_reader.h>
#include <tendon/ice/servants.h>

#include <algorithm>
#include <string_view>

namespace tendon::ice {
namespace {

constexpr std::string_view kTypes[] = {"::Ice::Object", "::tendon::Endpoint"};

std::vector<Ice::Byte> EncodeNothing() { return {6, 0, 0, 0, 1, 1}; }

std::vector<Ice::Byte> EncodeBool(bool value) {
  return {7, 0, 0, 0, 1, 1, static_cast<Ice::Byte>(value ? 1 : 0)};
}

/// The peer reads it where it waits for an answer. (Ice asks for a file and a line.)
[[noreturn]] void CutOff(IceLink& link, const std::string& what) {
  link.Fail({ErrorCode::kInvalid, link.peer() + " was cut off: " + what});
  throw Ice::MarshalException("tendon", 0, what);
}

std::vector<Ice::Byte> EncodeSequence(std::span<const std::byte> sequence) {
  thread_local Bytes encoded;
  WriteOnlyParameter(sequence, encoded);
  const auto* begin = reinterpret_cast<const Ice::Byte*>(encoded.data());
  return {begin, begin + encoded.size()};
}

/// What goes back at once: nothing, or one message. Holds until this thread asks again.
std::span<const std::byte> Ask(IceLink& link, std::span<const std::byte> frame, bool is_two_way) {
  thread_local Bytes answer;
  answer.clear();
  const bool may_return = is_two_way && link.MayReturn();
  if (!link.DeliverWhole(frame, may_return ? &answer : nullptr)) {
    CutOff(link, NoFrame(link.peer()).message);
  }
  if (!answer.empty()) link.OnReturned(answer.size());
  return answer;
}

bool IsA(std::span<const std::byte> type) {
  const std::string_view name(reinterpret_cast<const char*>(type.data()), type.size());
  return std::find(std::begin(kTypes), std::end(kTypes), name) != std::end(kTypes);
}

}  // namespace

bool EndpointServant::ice_invoke(std::pair<const Ice::Byte*, const Ice::Byte*> parameters,
                                 std::vector<Ice::Byte>& answer, const Ice::Current& current) {
  const auto link = LinkOf(current.con);
  if (!link) {
    throw Ice::ObjectNotExistException("tendon", 0, current.id, current.facet, current.operation);
  }
  if (current.requestId != 0) answer = EncodeNothing();
  if (current.operation == "ice_ping") return true;
  const bool is_frame = current.operation == "frame";
  const bool is_part = current.operation == "part";
  const bool is_ask = current.operation == "ask";
  if (!is_frame && !is_part && !is_ask && current.operation != "ice_isA") {
    throw Ice::OperationNotExistException("tendon", 0, current.id, current.facet,
                                          current.operation);
  }
  const auto parameter =
      ReadOnlyParameter(std::as_bytes(std::span(parameters.first, parameters.second)));
  if (!parameter) CutOff(*link, "the parameters of '" + current.operation + "' are malformed");
  if (is_ask) {
    answer = EncodeSequence(Ask(*link, *parameter, current.requestId != 0));
  } else if (!is_frame && !is_part) {
    answer = EncodeBool(IsA(*parameter));
  } else if (!link->Deliver(*parameter, is_frame)) {
    CutOff(*link, NoFrame(link->peer()).message);
  }
  return true;
}

std::shared_ptr<IceLink> EndpointServant::LinkOf(
    const std::shared_ptr<Ice::Connection>& connection) {
  return links_->Find(connection);
}

std::shared_ptr<IceLink> AcceptingServant::LinkOf(
    const std::shared_ptr<Ice::Connection>& connection) {
  if (auto known = links()->Find(connection)) return known;
  KeepFromPrograms(*connection);
  const std::scoped_lock lock(mutex_);
  if (!accept_) return nullptr;
  auto link = std::make_shared<IceLink>(connection, door_);
  auto handler = accept_(link);
  if (!handler) {
    link->CloseAtOnce();
    return nullptr;
  }
  link->SetHandler(std::move(handler));
  Links::Add(links(), link);
  return link;
}

void AcceptingServant::Stop() {
  {
    const std::scoped_lock lock(mutex_);
    accept_ = nullptr;
  }
  links()->CloseAll(door_);
}

}  // namespace tendon::ice
