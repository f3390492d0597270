#pragma once

#include <support/peers/wrapped.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tendon::test {

/// Records some frames of each type that are sent over the links that it opens, by address.
class RecordingMiddleware final : public WrappedMiddleware {
 public:
  using WrappedMiddleware::WrappedMiddleware;

  [[nodiscard]] std::vector<Bytes> FramesTo(const std::string& address) const {
    std::vector<Bytes> all;
    const std::scoped_lock lock(records_->mutex);
    for (const auto& [place, frames] : records_->frames) {
      if (place.first == address) all.insert(all.end(), frames.begin(), frames.end());
    }
    return all;
  }

  Result<std::shared_ptr<Link>> Open(const std::string& address,
                                     std::shared_ptr<LinkHandler> handler,
                                     std::chrono::milliseconds timeout) override {
    auto opened = WrappedMiddleware::Open(address, std::move(handler), timeout);
    if (!opened) return opened;
    return std::shared_ptr<Link>(
        std::make_shared<RecordedLink>(*std::move(opened), records_, address));
  }

 private:
  struct Records {
    std::mutex mutex;
    std::map<std::pair<std::string, MessageType>, std::vector<Bytes>> frames;
  };

  class RecordedLink final : public WrappedLink {
   public:
    RecordedLink(std::shared_ptr<Link> below, std::shared_ptr<Records> records, std::string address)
        : WrappedLink(std::move(below)),
          records_(std::move(records)),
          address_(std::move(address)) {}

    Status Send(std::span<const std::byte> frame, Delivery delivery) override {
      Keep(frame);
      return below().Send(frame, delivery);
    }

   private:
    void Keep(std::span<const std::byte> frame) {
      constexpr std::size_t kOfEach = 8;
      const auto header = ReadWholeFrame(frame);
      if (!header) return;
      const std::scoped_lock lock(records_->mutex);
      auto& kept = records_->frames[{address_, header->type}];
      if (kept.size() < kOfEach) kept.emplace_back(frame.begin(), frame.end());
    }

    const std::shared_ptr<Records> records_;
    const std::string address_;
  };

  const std::shared_ptr<Records> records_ = std::make_shared<Records>();
};

}  // namespace tendon::test
