#include <tendon/ice/outgoing_message.h>

#include <new>
#include <utility>

namespace tendon::ice {
namespace {

/// A reply of at least this size is not copied: the requester gets the buffer that Ice allocated.
constexpr std::size_t kLent = std::size_t{16} << 10U;

}  // namespace

void OutgoingMessage::Send(const std::string& operation, std::span<const std::byte> bytes) {
  const auto* const begin = reinterpret_cast<const Ice::Byte*>(bytes.data());
  try {
    prepare(operation, Ice::OperationMode::Normal, Ice::noExplicitContext);
    startWriteParams(Ice::FormatType::DefaultFormat)->write(begin, begin + bytes.size());
    endWriteParams();
    invoke(operation);
  } catch (const Ice::Exception& failure) {
    abort(failure);
  }
}

void OutgoingMessage::handleInvokeSent(bool /*at_once*/, OutgoingAsyncBase* /*self*/) const {
  link_->OnSent(counted_, accounting_.returned_before);
}

void OutgoingMessage::handleInvokeException(const Ice::Exception& why,
                                            OutgoingAsyncBase* /*self*/) const {
  link_->OnFailed(counted_, request_, why);
}

void OutgoingMessage::handleInvokeResponse(bool /*ok*/, OutgoingAsyncBase* self) const {
  const Ice::Byte* begin = nullptr;
  Ice::Int size = 0;
  Ice::InputStream& in = *self->getIs();
  if (!in.b.empty()) in.readEncapsulation(begin, size);
  const auto reply = std::as_bytes(std::span(begin, static_cast<std::size_t>(size)));
  std::shared_ptr<IceInternal::Buffer> owner;
  if (reply.size() >= kLent) {
    try {
      owner = std::make_shared<IceInternal::Buffer>();
      owner->swapBuffer(in);           // does not move the bytes
    } catch (const std::bad_alloc&) {  // the reply is copied instead
      owner.reset();
    }
  }
  link_->OnReply(counted_, reply, std::move(owner));
}

}  // namespace tendon::ice
