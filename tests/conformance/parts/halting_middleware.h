#pragma once

#include <support/peers/wrapped.h>

#include <atomic>
#include <memory>
#include <string>
#include <utility>

namespace tendon::conformance {

/// A middleware whose links pass on a given number of parts of large messages, and no further
/// parts.
class HaltingMiddleware final : public test::WrappedMiddleware {
 public:
  HaltingMiddleware(std::shared_ptr<Middleware> below, int parts)
      : WrappedMiddleware(std::move(below)), parts_(parts) {}

  Result<std::shared_ptr<Link>> Open(const std::string& address,
                                     std::shared_ptr<LinkHandler> handler,
                                     std::chrono::milliseconds timeout) override {
    auto link = WrappedMiddleware::Open(address, std::move(handler), timeout);
    if (!link) return link.error();
    return std::shared_ptr<Link>(std::make_shared<HaltingLink>(*std::move(link), parts_));
  }

 private:
  class HaltingLink final : public test::WrappedLink {
   public:
    HaltingLink(std::shared_ptr<Link> below, int parts)
        : WrappedLink(std::move(below)), left_(parts) {}

    Status Send(std::span<const std::byte> frame, Delivery delivery) override {
      const bool is_part = ReadWholeFrame(frame)->type == MessageType::kPart;
      if (is_part && left_.fetch_sub(1) <= 0) return Status::kQueueFull;
      return WrappedLink::Send(frame, delivery);
    }

   private:
    std::atomic<int> left_;
  };

  const int parts_;
};

}  // namespace tendon::conformance
