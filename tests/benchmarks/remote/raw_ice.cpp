#include <Ice/Ice.h>
#include <Ice/Incoming.h>
#include <benchmarks/remote/raw_ice.h>
#include <tendon/ice/connection_socket.h>
#include <tendon/ice/settings.h>

#include <chrono>
#include <cstring>
#include <utility>

namespace tendon::benchmark {
namespace {

using Range = std::pair<const Ice::Byte*, const Ice::Byte*>;

/// Makes an encapsulation of Ice: its size, the version of the encoding, and the bytes.
std::vector<Ice::Byte> Encapsulate(std::span<const std::byte> bytes) {
  constexpr std::size_t kHeader = 6;
  const auto size = static_cast<Ice::Int>(kHeader + bytes.size());
  std::vector<Ice::Byte> all(kHeader + bytes.size());
  std::memcpy(all.data(), &size, sizeof(size));
  all[4] = all[5] = 1;
  if (!bytes.empty()) std::memcpy(all.data() + kHeader, bytes.data(), bytes.size());
  return all;
}

Range RangeOf(const std::vector<Ice::Byte>& bytes) {
  return {bytes.data(), bytes.data() + bytes.size()};
}

Ice::InitializationData OurSettings() {
  Ice::InitializationData settings = ice::Settings();
  // KiB; an image is sent in one piece
  settings.properties->setProperty("Ice.MessageSizeMax", "2048");
  settings.properties->setProperty("Growing.ThreadPool.Serialize", "1");
  settings.properties->setProperty("Growing.ThreadPool.Size", "1");
  settings.properties->setProperty("Growing.ThreadPool.SizeMax", "4");
  return settings;
}

/// Dispatches by hand, like generated code, but without unnecessary copies.
class Servant final : public Ice::Object {
 public:
  bool _iceDispatch(IceInternal::Incoming& incoming, const Ice::Current& current) override {
    const Ice::Byte* parameter = nullptr;
    Ice::Int size = 0;
    incoming.readParamEncaps(parameter, size);
    const auto& reply = AnswerTo(current);
    incoming.writeParamEncaps(reply.data(), static_cast<Ice::Int>(reply.size()), true);
    return true;  // the request is answered
  }

 private:
  const std::vector<Ice::Byte>& AnswerTo(const Ice::Current& current) {
    if (current.operation == "get") return message_;
    if (current.operation == "image") return image_;
    if (current.operation == "copied image") return copied_ = image_;
    if (current.operation == "adopt") ice::AdoptSocket(*current.con);
    return nothing_;
  }

  const std::vector<Ice::Byte> message_ = Encapsulate(std::vector<std::byte>(sizeof(Message)));
  const std::vector<Ice::Byte> image_ = Encapsulate(std::vector<std::byte>(kImageBytes));
  std::vector<Ice::Byte> copied_;  // only one request at a time uses this
  const std::vector<Ice::Byte> nothing_ = Encapsulate({});
};

}  // namespace

class RawIceServer::Parts {
 public:
  ~Parts() { communicator_->destroy(); }

  [[nodiscard]] std::string address() const { return AddressOf(*growing_); }
  [[nodiscard]] std::string address_of_one_thread() const { return AddressOf(*one_thread_); }

 private:
  std::shared_ptr<Ice::ObjectAdapter> Serve(const std::string& name) {
    auto adapter = communicator_->createObjectAdapterWithEndpoints(name, "tcp -h 127.0.0.1 -p 0");
    adapter->add(std::make_shared<Servant>(), {"floor", ""});
    adapter->activate();
    return adapter;
  }
  static std::string AddressOf(const Ice::ObjectAdapter& adapter) {
    const auto info = adapter.getEndpoints().front()->getInfo();
    return std::to_string(std::dynamic_pointer_cast<Ice::TCPEndpointInfo>(info)->port);
  }

  const std::shared_ptr<Ice::Communicator> communicator_ = Ice::initialize(OurSettings());
  const std::shared_ptr<Ice::ObjectAdapter> growing_ = Serve("Growing");
  const std::shared_ptr<Ice::ObjectAdapter> one_thread_ = Serve("OneThread");
};

RawIceServer::RawIceServer() : parts_(std::make_unique<Parts>()) {}
RawIceServer::~RawIceServer() = default;
std::string RawIceServer::address() const { return parts_->address(); }
std::string RawIceServer::address_of_one_thread() const { return parts_->address_of_one_thread(); }

class RawIce::Parts {
 public:
  explicit Parts(const std::string& address)
      : two_way_(communicator_->stringToProxy("floor:tcp -h 127.0.0.1 -p " + address)) {
    std::vector<Ice::Byte> nothing;
    two_way_->ice_invoke("adopt", Ice::OperationMode::Normal, Range{}, nothing);
    ice::AdoptSocket(*two_way_->ice_getCachedConnection());
  }
  ~Parts() { communicator_->destroy(); }

  [[nodiscard]] const std::shared_ptr<Ice::ObjectPrx>& two_way() const { return two_way_; }
  [[nodiscard]] const std::shared_ptr<Ice::ObjectPrx>& oneway() const { return oneway_; }
  [[nodiscard]] const std::shared_ptr<Ice::ObjectPrx>& batch() const { return batch_; }
  std::string NewConnectionId() { return std::to_string(++connections_); }

 private:
  const std::shared_ptr<Ice::Communicator> communicator_ = Ice::initialize(OurSettings());
  const std::shared_ptr<Ice::ObjectPrx> two_way_;
  const std::shared_ptr<Ice::ObjectPrx> oneway_ = two_way_->ice_oneway();
  const std::shared_ptr<Ice::ObjectPrx> batch_ = two_way_->ice_batchOneway();
  int connections_ = 0;
};

RawIce::RawIce(const std::string& address) : parts_(std::make_unique<Parts>(address)) {}
RawIce::~RawIce() = default;

void RawIce::Read(Message& reply) {
  constexpr std::size_t kHeader = 6;
  std::vector<Ice::Byte> bytes;
  parts_->two_way()->ice_invoke("get", Ice::OperationMode::Normal, Range{}, bytes);
  std::memcpy(&reply, bytes.data() + kHeader, sizeof(reply));
}

void RawIce::Write(std::span<const std::byte> parameter, std::uint64_t times) {
  const auto bytes = Encapsulate(parameter);
  std::vector<Ice::Byte> nothing;
  for (std::uint64_t i = 0; i < times; ++i) {
    parts_->oneway()->ice_invoke("put", Ice::OperationMode::Normal, RangeOf(bytes), nothing);
  }
  parts_->two_way()->ice_ping();
}

void RawIce::WriteBatches(std::span<const std::byte> parameter, std::uint64_t times,
                          std::uint64_t size) {
  const auto bytes = Encapsulate(parameter);
  std::vector<Ice::Byte> nothing;
  for (std::uint64_t i = 1; i <= times; ++i) {
    parts_->batch()->ice_invoke("put", Ice::OperationMode::Normal, RangeOf(bytes), nothing);
    if (i % size == 0 || i == times) parts_->batch()->ice_flushBatchRequests();
  }
  parts_->two_way()->ice_ping();
}

void RawIce::BeginRead(std::function<void(bool ok)> done) {
  parts_->two_way()->ice_invokeAsync(
      "get", Ice::OperationMode::Normal, Range{}, [done](bool ok, const Range&) { done(ok); },
      [done](const std::exception_ptr&) { done(false); });
}

std::size_t RawIce::ReadImage(Image image) {
  const char* const operation = image == Image::kThere ? "image" : "copied image";
  std::vector<Ice::Byte> bytes;
  parts_->two_way()->ice_invoke(operation, Ice::OperationMode::Normal, Range{}, bytes);
  return bytes.size();
}

double RawIce::Connect() {
  const auto proxy = parts_->two_way()->ice_connectionId(parts_->NewConnectionId());
  const auto start = std::chrono::steady_clock::now();
  proxy->ice_ping();
  const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
  proxy->ice_getCachedConnection()->close(Ice::ConnectionClose::Forcefully);
  return took.count();
}

}  // namespace tendon::benchmark
