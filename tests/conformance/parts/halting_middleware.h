#pragma once

#include <tendon/middleware/middleware.h>

#include <atomic>
#include <memory>
#include <string>
#include <utility>

namespace tendon::conformance {

/// A middleware over whose links so many parts of large messages go, and then no more.
class HaltingMiddleware final : public Middleware {
 public:
  HaltingMiddleware(Middleware& below, int parts) : below_(below), parts_(parts) {}

  [[nodiscard]] std::string_view name() const override { return below_.name(); }
  Result<std::unique_ptr<Listener>> Listen(const std::string& address, AcceptLink accept) override {
    return below_.Listen(address, std::move(accept));
  }
  Result<std::shared_ptr<Link>> Open(const std::string& address,
                                     std::shared_ptr<LinkHandler> handler,
                                     std::chrono::milliseconds timeout) override {
    auto link = below_.Open(address, std::move(handler), timeout);
    if (!link) return link.error();
    return std::shared_ptr<Link>(std::make_shared<HaltingLink>(*std::move(link), parts_));
  }

 private:
  class HaltingLink final : public Link {
   public:
    HaltingLink(std::shared_ptr<Link> below, int parts) : below_(std::move(below)), left_(parts) {}

    Status Send(std::span<const std::byte> frame) override {
      const bool is_part = ReadWholeFrame(frame)->type == MessageType::kPart;
      if (is_part && left_.fetch_sub(1) <= 0) return Status::kQueueFull;
      return below_->Send(frame);
    }
    void Admit() override { below_->Admit(); }
    void Close() override { below_->Close(); }
    [[nodiscard]] std::string peer() const override { return below_->peer(); }
    [[nodiscard]] std::string local() const override { return below_->local(); }
    [[nodiscard]] const Certificate* certificate() const override { return below_->certificate(); }

   private:
    const std::shared_ptr<Link> below_;
    std::atomic<int> left_;
  };

  Middleware& below_;
  const int parts_;
};

}  // namespace tendon::conformance
