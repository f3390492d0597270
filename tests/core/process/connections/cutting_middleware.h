#pragma once

#include <support/peers/wrapped.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

/// A middleware whose opened links can be cut, like a cable. Frames sent before the cut may arrive;
/// afterwards nothing passes. Both ends are notified.
class CuttingMiddleware final : public tendon::test::WrappedMiddleware {
 public:
  /// Links to `spared` are never cut.
  CuttingMiddleware(std::shared_ptr<tendon::Middleware> below, std::string spared)
      : WrappedMiddleware(std::move(below)), spared_(std::move(spared)) {}

  void Cut() {
    std::vector<std::shared_ptr<Cable>> cables;
    {
      const std::scoped_lock lock(mutex_);
      cables.swap(cables_);
    }
    for (const auto& cable : cables) {
      cable->is_cut = true;
      cable->link->Close();
    }
  }

  tendon::Result<std::shared_ptr<tendon::Link>> Open(const std::string& address,
                                                     std::shared_ptr<tendon::LinkHandler> handler,
                                                     std::chrono::milliseconds timeout) override {
    if (address == spared_) return WrappedMiddleware::Open(address, std::move(handler), timeout);
    auto cable = std::make_shared<Cable>();
    auto opened =
        WrappedMiddleware::Open(address, std::make_shared<Ear>(cable, std::move(handler)), timeout);
    if (!opened) return opened;
    cable->link = *std::move(opened);
    const std::scoped_lock lock(mutex_);
    cables_.push_back(cable);
    return std::shared_ptr<tendon::Link>(std::make_shared<Mouth>(std::move(cable)));
  }

 private:
  struct Cable {
    std::atomic<bool> is_cut{false};
    std::shared_ptr<tendon::Link> link;
  };

  /// Handles the frames that arrive.
  class Ear final : public tendon::LinkHandler {
   public:
    Ear(std::shared_ptr<Cable> cable, std::shared_ptr<tendon::LinkHandler> handler)
        : cable_(std::move(cable)), handler_(std::move(handler)) {}
    void OnFrame(std::span<const std::byte> frame) override {
      if (!cable_->is_cut) handler_->OnFrame(frame);
    }
    void OnClosed(const tendon::Error& reason) override { handler_->OnClosed(reason); }

   private:
    const std::shared_ptr<Cable> cable_;
    const std::shared_ptr<tendon::LinkHandler> handler_;
  };

  /// Sends the frames of this end.
  class Mouth final : public tendon::test::WrappedLink {
   public:
    explicit Mouth(std::shared_ptr<Cable> cable)
        : WrappedLink(cable->link), cable_(std::move(cable)) {}
    tendon::Status Send(std::span<const std::byte> frame, tendon::Delivery delivery) override {
      return cable_->is_cut ? tendon::Status::kQueued : below().Send(frame, delivery);
    }

   private:
    const std::shared_ptr<Cable> cable_;
  };

  const std::string spared_;
  std::mutex mutex_;
  std::vector<std::shared_ptr<Cable>> cables_;
};
