#include <tendon/ice/replies.h>

#include <Ice/IncomingAsync.h>

#include <utility>

namespace tendon::ice {
namespace {

std::span<std::byte> RoomIn(IceInternal::IncomingBase& call, const FrameHeader& header) {
  const std::size_t size = FrameHeader::kSize + header.size;
  Ice::OutputStream& out = *call.startWriteParams();
  out.writeSize(static_cast<Ice::Int>(size));
  const std::size_t before = out.b.size();
  out.resize(before + size);
  const auto frame = std::as_writable_bytes(std::span(out.b.begin() + before, size));
  WriteHeader(header, frame.first<FrameHeader::kSize>());
  return frame.subspan(FrameHeader::kSize);
}

}  // namespace

std::optional<std::span<std::byte>> ImmediateReply::MakeRoom(const FrameHeader& header) {
  return RoomIn(incoming_, header);
}

std::unique_ptr<ReplySlot> ImmediateReply::MakeDeferred() {
  auto later = std::make_unique<DeferredReply>(link_.shared_from_this());
  auto call = IceInternal::IncomingAsync::create(incoming_);
  is_deferred_ = true;  // Ice accepts no immediate reply now
  later->Take(std::move(call));
  return later;
}

void DeferredReply::Take(PendingCalls::Call call) noexcept {
  call_ = std::move(call);
  link_->pending_calls().Add(call_);
}

DeferredReply::~DeferredReply() {
  if (is_there()) return;
  if (has_begun()) {
    SendFailure(*call_);
  } else if (link_->pending_calls().Take(call_)) {
    SendEmptyReply(*call_);
  }
}

std::optional<std::span<std::byte>> DeferredReply::MakeRoom(const FrameHeader& header) {
  if (!link_->MayReturn() || !link_->pending_calls().Take(call_)) return std::nullopt;
  return RoomIn(*call_, header);
}

void DeferredReply::OnEnd() {
  call_->endWriteParams();
  call_->completed();
  link_->CountReturned(size());
}

}  // namespace tendon::ice
