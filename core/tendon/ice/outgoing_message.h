#pragma once

#include <Ice/Ice.h>
#include <Ice/OutgoingAsync.h>
#include <tendon/ice/ice_link.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace tendon::ice {

/// A message that a link sends through Ice, with one sequence of bytes as its parameter. Does the
/// same as generated code, but with only one memory allocation and without function objects.
/// Reports its outcome to the link once. Must be created with std::make_shared().
class OutgoingMessage final : public IceInternal::OutgoingAsync {
 public:
  /// The values that the link needs when Ice has sent the message.
  struct SendAccounting {
    std::size_t size = 0;  ///< bytes that the link counts as unsent for this message
    std::uint64_t returned_before = 0;
  };
  /// If a reply is expected, `peer` must be a two-way proxy, and `request` is the header of the
  /// frame.
  OutgoingMessage(const std::shared_ptr<Ice::ObjectPrx>& peer, std::shared_ptr<IceLink> link,
                  const SendAccounting& accounting, const std::optional<FrameHeader>& request)
      : OutgoingAsync(peer, false),
        link_(std::move(link)),
        accounting_(accounting),
        counted_(accounting.size),
        request_(request) {}

  /// Begins to send; never blocks. Throws if Ice has ended; then no outcome is reported to the
  /// link.
  void Send(const std::string& operation, std::span<const std::byte> bytes);

 private:
  // Called by Ice. The results of the first three functions decide whether Ice calls the last three
  // functions.
  bool handleSent(bool is_done, bool was_sent) override {
    return !was_sent && (is_done || accounting_.size >= kLarge);
  }
  bool handleException(const Ice::Exception& /*why*/) override { return true; }
  bool handleResponse(bool /*ok*/) override { return true; }
  void handleInvokeSent(bool at_once, OutgoingAsyncBase* self) const override;
  void handleInvokeException(const Ice::Exception& why, OutgoingAsyncBase* self) const override;
  void handleInvokeResponse(bool ok, OutgoingAsyncBase* self) const override;

  /// A request of at least this size is no longer counted as unsent after it was sent, because its
  /// reply may take long. A smaller request is counted until it is answered.
  static constexpr std::size_t kLarge = std::size_t{16} << 10U;

  const std::shared_ptr<IceLink> link_;
  const SendAccounting accounting_;
  mutable std::size_t counted_;  // bytes that the link still counts
  const std::optional<FrameHeader> request_;
};

}  // namespace tendon::ice
