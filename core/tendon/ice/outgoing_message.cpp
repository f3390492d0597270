#include <tendon/ice/outgoing_message.h>

namespace tendon::ice {

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
  link_->OnSent(told_.size, told_.returned_before);
}

void OutgoingMessage::handleInvokeException(const Ice::Exception& why,
                                            OutgoingAsyncBase* /*self*/) const {
  link_->OnFailed(told_.size, question_, why);
}

void OutgoingMessage::handleInvokeResponse(bool /*ok*/, OutgoingAsyncBase* self) const {
  const Ice::Byte* begin = nullptr;
  Ice::Int size = 0;
  if (!self->getIs()->b.empty()) self->getIs()->readEncapsulation(begin, size);
  link_->OnAnswer(told_.size, std::as_bytes(std::span(begin, static_cast<std::size_t>(size))));
}

}  // namespace tendon::ice
