#pragma once

#include <Ice/Ice.h>
#include <Ice/OutgoingAsync.h>
#include <tendon/ice/links.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace tendon::ice {

/// A message that a link sends through Ice, with one sequence of bytes. Does what generated code
/// does, but with one allocation and no function object. Reports its outcome to its link once.
/// Create it with std::make_shared().
class OutgoingMessage final : public IceInternal::OutgoingAsync {
 public:
  /// The data that the link needs when the message was sent.
  struct SendAccounting {
    std::size_t size = 0;  ///< as counted by the link
    std::uint64_t returned_before = 0;
  };
  /// `peer` is two-way if an answer is expected; then `request` is the header.
  OutgoingMessage(const std::shared_ptr<Ice::ObjectPrx>& peer, std::shared_ptr<IceLink> link,
                  const SendAccounting& accounting, const std::optional<FrameHeader>& request)
      : OutgoingAsync(peer, false),
        link_(std::move(link)),
        accounting_(accounting),
        counted_(accounting.size),
        request_(request) {}

  /// Starts to send; never waits. Throws if Ice has ended; then the link gets no outcome.
  void Send(const std::string& operation, std::span<const std::byte> bytes);

 private:
  // Called by Ice; the first three decide whether it calls the others.
  bool handleSent(bool is_done, bool was_sent) override {
    return !was_sent && (is_done || accounting_.size >= kLarge);
  }
  bool handleException(const Ice::Exception& /*why*/) override { return true; }
  bool handleResponse(bool /*ok*/) override { return true; }
  void handleInvokeSent(bool at_once, OutgoingAsyncBase* self) const override;
  void handleInvokeException(const Ice::Exception& why, OutgoingAsyncBase* self) const override;
  void handleInvokeResponse(bool ok, OutgoingAsyncBase* self) const override;

  /// A request of at least this size is removed from the window when it was sent, because its
  /// answer may take long.
  static constexpr std::size_t kLarge = std::size_t{16} << 10U;

  const std::shared_ptr<IceLink> link_;
  const SendAccounting accounting_;
  mutable std::size_t counted_;  // bytes still counted by the link
  const std::optional<FrameHeader> request_;
};

}  // namespace tendon::ice
