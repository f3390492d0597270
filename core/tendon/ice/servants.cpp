#include <tendon/ice/servants.h>

#include <Ice/Incoming.h>
#include <tendon/ice/bounded_reader.h>
#include <tendon/ice/replies.h>

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <string_view>

namespace tendon::ice {
namespace {

constexpr std::string_view kTypes[] = {"::Ice::Object", "::tendon::Endpoint"};

// Encoded results: nothing, false and true.
constexpr std::array kNothing{std::byte{6}, std::byte{0}, std::byte{0},
                              std::byte{0}, std::byte{1}, std::byte{1}};
constexpr std::array kNo{std::byte{7}, std::byte{0}, std::byte{0}, std::byte{0},
                         std::byte{1}, std::byte{1}, std::byte{0}};
constexpr std::array kYes{std::byte{7}, std::byte{0}, std::byte{0}, std::byte{0},
                          std::byte{1}, std::byte{1}, std::byte{1}};

/// Closes the link because the peer violates the protocol. If the peer waits for a reply, it
/// receives the text `what`. (The exception of Ice requires a file and a line.)
[[noreturn]] void CutOff(IceLink& link, const std::string& what) {
  link.Fail({ErrorCode::kInvalid, link.peer() + " was disconnected: " + what});
  throw Ice::MarshalException("tendon", 0, what);
}

/// Delivers the frame of an `ask` and writes the result, which is a frame or empty. Returns false
/// if the reply is deferred.
bool Ask(IceLink& link, std::span<const std::byte> frame, IceInternal::Incoming& incoming) {
  ImmediateReply reply(link, incoming);
  if (!link.DeliverDirect(frame, reply)) CutOff(link, NoFrame(link.peer()).message);
  if (reply.is_deferred()) return false;
  if (!reply.has_begun()) {
    incoming.startWriteParams()->writeSize(0);
  } else if (!reply.is_there()) {
    throw std::runtime_error("the reply could not be written");  // makes Ice discard the reply
  }
  incoming.endWriteParams();
  return true;
}

bool Write(std::span<const std::byte> reply, IceInternal::Incoming& incoming) {
  incoming.writeParamEncaps(reinterpret_cast<const Ice::Byte*>(reply.data()),
                            static_cast<Ice::Int>(reply.size()), true);
  return true;
}

bool IsA(std::span<const std::byte> type) {
  const std::string_view name(reinterpret_cast<const char*>(type.data()), type.size());
  return std::find(std::begin(kTypes), std::end(kTypes), name) != std::end(kTypes);
}

}  // namespace

bool EndpointServant::_iceDispatch(IceInternal::Incoming& incoming, const Ice::Current& current) {
  const Ice::Byte* begin = nullptr;
  Ice::Int size = 0;
  incoming.readParamEncaps(begin, size);
  const auto parameters = std::as_bytes(std::span(begin, static_cast<std::size_t>(size)));
  return Dispatch(parameters, current, incoming);
}

/// Executes a call and writes its result. Returns false if the result is written later.
bool EndpointServant::Dispatch(std::span<const std::byte> parameters, const Ice::Current& current,
                               IceInternal::Incoming& incoming) {
  const auto link = LinkOf(current.con);
  if (!link) {
    throw Ice::ObjectNotExistException("tendon", 0, current.id, current.facet, current.operation);
  }
  // Contexts are not used, and Ice keeps a context in memory while the call is open. Therefore, a
  // peer must not send a context.
  if (!current.ctx.empty()) CutOff(*link, "it sends a context with '" + current.operation + "'");
  if (current.operation == "ice_ping") return Write(kNothing, incoming);
  const bool is_frame = current.operation == "frame";
  const bool is_ask = current.operation == "ask";
  if (!is_frame && !is_ask && current.operation != "ice_isA") {
    throw Ice::OperationNotExistException("tendon", 0, current.id, current.facet,
                                          current.operation);
  }
  const auto parameter = ReadOnlyParameter(parameters);
  if (!parameter) CutOff(*link, "the parameters of '" + current.operation + "' are malformed");
  const bool is_two_way = current.requestId != 0;
  if (is_ask && is_two_way) return Ask(*link, *parameter, incoming);
  if (current.operation == "ice_isA") return Write(IsA(*parameter) ? kYes : kNo, incoming);
  if (!link->Deliver(*parameter)) CutOff(*link, NoFrame(link->peer()).message);
  return Write(kNothing, incoming);
}

std::shared_ptr<IceLink> EndpointServant::LinkOf(
    const std::shared_ptr<Ice::Connection>& connection) {
  return links_->Find(connection);
}

std::shared_ptr<IceLink> AcceptingServant::LinkOf(
    const std::shared_ptr<Ice::Connection>& connection) {
  if (auto known = links()->Find(connection)) return known;
  AdoptSocket(*connection);
  const std::scoped_lock lock(mutex_);
  if (!accept_) return nullptr;
  auto link = std::make_shared<IceLink>(connection, listener_);
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
  links()->CloseAll(listener_);
}

}  // namespace tendon::ice
