#include <Ice/Incoming.h>
#include <tendon/ice/bounded_reader.h>
#include <tendon/ice/servants.h>

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <string_view>

namespace tendon::ice {
namespace {

constexpr std::string_view kTypes[] = {"::Ice::Object", "::tendon::Endpoint"};

// As parameters.
constexpr std::array kNothing{std::byte{6}, std::byte{0}, std::byte{0},
                              std::byte{0}, std::byte{1}, std::byte{1}};
constexpr std::array kNo{std::byte{7}, std::byte{0}, std::byte{0}, std::byte{0},
                         std::byte{1}, std::byte{1}, std::byte{0}};
constexpr std::array kYes{std::byte{7}, std::byte{0}, std::byte{0}, std::byte{0},
                          std::byte{1}, std::byte{1}, std::byte{1}};

/// The peer reads it where it waits for an answer. (Ice asks for a file and a line.)
[[noreturn]] void CutOff(IceLink& link, const std::string& what) {
  link.Fail({ErrorCode::kInvalid, link.peer() + " was cut off: " + what});
  throw Ice::MarshalException("tendon", 0, what);
}

/// A frame as the only parameter of what Ice sends back.
class ReturnedFrame final : public LeftAnswer {
 public:
  explicit ReturnedFrame(IceInternal::Incoming& incoming) : incoming_(incoming) {}

 private:
  std::span<std::byte> MakeRoom(const FrameHeader& header) override {
    const std::size_t size = FrameHeader::kSize + header.size;
    Ice::OutputStream& out = *incoming_.startWriteParams();
    out.writeSize(static_cast<Ice::Int>(size));
    const std::size_t before = out.b.size();
    out.resize(before + size);
    const auto frame = std::as_writable_bytes(std::span(out.b.begin() + before, size));
    WriteHeader(header, frame.first<FrameHeader::kSize>());
    return frame.subspan(FrameHeader::kSize);
  }

  IceInternal::Incoming& incoming_;
};

/// What goes back at once is the only parameter: nothing, or one frame.
void Ask(IceLink& link, std::span<const std::byte> frame, IceInternal::Incoming& incoming) {
  ReturnedFrame answer(incoming);
  if (!link.DeliverAsked(frame, answer)) CutOff(link, NoFrame(link.peer()).message);
  if (!answer.has_begun()) {
    incoming.startWriteParams()->writeSize(0);
  } else if (!answer.is_there()) {
    throw std::runtime_error("the answer could not be written");  // Ice forgets what there is
  }
  incoming.endWriteParams();
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
  const auto answer = Dispatch(parameters, current, incoming);
  if (answer.empty()) return true;  // it is written
  incoming.writeParamEncaps(reinterpret_cast<const Ice::Byte*>(answer.data()),
                            static_cast<Ice::Int>(answer.size()), true);
  return true;
}

/// Its answer, which a oneway does not get; empty where that was written to `incoming`.
std::span<const std::byte> EndpointServant::Dispatch(std::span<const std::byte> parameters,
                                                     const Ice::Current& current,
                                                     IceInternal::Incoming& incoming) {
  const auto link = LinkOf(current.con);
  if (!link) {
    throw Ice::ObjectNotExistException("tendon", 0, current.id, current.facet, current.operation);
  }
  if (current.operation == "ice_ping") return kNothing;
  const bool is_frame = current.operation == "frame";
  const bool is_ask = current.operation == "ask";
  if (!is_frame && !is_ask && current.operation != "ice_isA") {
    throw Ice::OperationNotExistException("tendon", 0, current.id, current.facet,
                                          current.operation);
  }
  const auto parameter = ReadOnlyParameter(parameters);
  if (!parameter) CutOff(*link, "the parameters of '" + current.operation + "' are malformed");
  const bool is_two_way = current.requestId != 0;
  if (is_ask && is_two_way) {
    Ask(*link, *parameter, incoming);
    return {};
  }
  if (current.operation == "ice_isA") return IsA(*parameter) ? kYes : kNo;
  if (!link->Deliver(*parameter)) CutOff(*link, NoFrame(link->peer()).message);
  return kNothing;
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
