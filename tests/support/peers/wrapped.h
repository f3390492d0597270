#pragma once

#include <tendon/middleware/middleware.h>

#include <chrono>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace tendon::test {

/// A link that passes everything on to another link. A test overrides parts of it. All frames are
/// queued, unless Send() is overridden.
class WrappedLink : public Link {
 public:
  explicit WrappedLink(std::shared_ptr<Link> below) : below_(std::move(below)) {}

  Status Send(std::span<const std::byte> frame, Delivery /*delivery*/) override {
    return below_->Send(frame);
  }
  void Admit() override { below_->Admit(); }
  void Close() override { below_->Close(); }
  [[nodiscard]] std::string peer() const override { return below_->peer(); }
  [[nodiscard]] std::string local() const override { return below_->local(); }
  [[nodiscard]] const Certificate* certificate() const override { return below_->certificate(); }

 protected:
  [[nodiscard]] Link& below() const { return *below_; }

 private:
  const std::shared_ptr<Link> below_;
};

/// A middleware that passes everything on to another middleware. A test overrides parts of it.
class WrappedMiddleware : public Middleware {
 public:
  explicit WrappedMiddleware(std::shared_ptr<Middleware> below) : below_(std::move(below)) {}

  [[nodiscard]] std::string_view name() const override { return below_->name(); }
  [[nodiscard]] const Certificate* certificate() const override { return below_->certificate(); }
  Result<std::unique_ptr<Listener>> Listen(const std::string& address, AcceptLink accept) override {
    return below_->Listen(address, std::move(accept));
  }
  Result<std::shared_ptr<Link>> Open(const std::string& address,
                                     std::shared_ptr<LinkHandler> handler,
                                     std::chrono::milliseconds timeout) override {
    return below_->Open(address, std::move(handler), timeout);
  }

 private:
  const std::shared_ptr<Middleware> below_;
};

}  // namespace tendon::test
