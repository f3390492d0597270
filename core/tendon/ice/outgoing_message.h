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

/// One message of Ice that a link sends, with one sequence of bytes: made as generated code makes
/// it, in one piece of memory and without a function object. Its link is told once what became of
/// it. Only by std::make_shared().
class OutgoingMessage final : public IceInternal::OutgoingAsync {
 public:
  /// What the link is told when the message has left.
  struct Told {
    std::size_t size = 0;  ///< as the link counts it
    std::uint64_t returned_before = 0;
  };
  /// `peer` says whether an answer is wanted, `question` which.
  OutgoingMessage(const std::shared_ptr<Ice::ObjectPrx>& peer, std::shared_ptr<IceLink> link,
                  const Told& told, const std::optional<FrameHeader>& question)
      : OutgoingAsync(peer, false),
        link_(std::move(link)),
        told_(told),
        counted_(told.size),
        question_(question) {}

  /// Begins; never waits. Throws where Ice has ended, and the link is not told.
  void Send(const std::string& operation, std::span<const std::byte> bytes);

 private:
  // What Ice calls; the first three, whether it shall call the others.
  bool handleSent(bool is_done, bool was_sent) override {
    return !was_sent && (is_done || told_.size >= kLarge);
  }
  bool handleException(const Ice::Exception& /*why*/) override { return true; }
  bool handleResponse(bool /*ok*/) override { return true; }
  void handleInvokeSent(bool at_once, OutgoingAsyncBase* self) const override;
  void handleInvokeException(const Ice::Exception& why, OutgoingAsyncBase* self) const override;
  void handleInvokeResponse(bool ok, OutgoingAsyncBase* self) const override;

  /// A question from this size on takes no room in the window any more once it was sent: an answer
  /// to it may be long in coming.
  static constexpr std::size_t kLarge = std::size_t{16} << 10U;

  const std::shared_ptr<IceLink> link_;
  const Told told_;
  mutable std::size_t counted_;  // by the link still
  const std::optional<FrameHeader> question_;
};

}  // namespace tendon::ice
