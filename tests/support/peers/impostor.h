#pragma once

#include <tendon/middleware/body.h>
#include <tendon/middleware/handshake.h>
#include <tendon/middleware/middleware.h>

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tendon::test {

/// A program that listens under the name of a process and answers a Hello, without knowing the
/// cookie. Stores everything that it receives.
class Impostor {
 public:
  Impostor(std::shared_ptr<Middleware> middleware, const std::string& name)
      : middleware_(std::move(middleware)) {
    auto listener = middleware_->Listen("127.0.0.1:0",
                                        [heard = heard_, name](const std::shared_ptr<Link>& link) {
                                          const std::scoped_lock lock(heard->mutex);
                                          ++heard->links;
                                          return std::make_shared<Guest>(heard, link, name);
                                        });
    if (listener) listener_ = *std::move(listener);
  }

  [[nodiscard]] std::string address() const { return listener_ ? listener_->address() : ""; }
  /// The number of links so far.
  [[nodiscard]] int links() const {
    const std::scoped_lock lock(heard_->mutex);
    return heard_->links;
  }
  [[nodiscard]] std::vector<MessageType> heard() const {
    const std::scoped_lock lock(heard_->mutex);
    return heard_->types;
  }

 private:
  struct Heard {
    std::mutex mutex;
    int links = 0;
    std::vector<MessageType> types;
  };

  class Guest final : public LinkHandler {
   public:
    Guest(std::shared_ptr<Heard> heard, std::weak_ptr<Link> link, std::string name)
        : heard_(std::move(heard)), link_(std::move(link)), name_(std::move(name)) {}

    void OnFrame(std::span<const std::byte> frame) override {
      FrameHeader header = *ReadWholeFrame(frame);
      {
        const std::scoped_lock lock(heard_->mutex);
        heard_->types.push_back(header.type);
      }
      const auto link = link_.lock();
      if (header.type != MessageType::kHello || !link) return;
      message::Challenge challenge;
      challenge.greeting.name = name_;
      challenge.proof.fill(1);
      const Bytes body = EncodeBody(challenge);
      header.type = MessageType::kChallenge;
      header.size = static_cast<std::uint32_t>(body.size());
      Bytes answer;
      WriteFrame(header, body, answer);
      (void)link->Send(answer);
    }
    void OnClosed(const Error& /*reason*/) override {}

   private:
    const std::shared_ptr<Heard> heard_;
    const std::weak_ptr<Link> link_;
    const std::string name_;
  };

  const std::shared_ptr<Heard> heard_ = std::make_shared<Heard>();
  const std::shared_ptr<Middleware> middleware_;
  std::unique_ptr<Listener> listener_;
};

}  // namespace tendon::test
