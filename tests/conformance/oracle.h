#pragma once

#include <tendon/middleware/channel.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "conformance/recorder.h"

namespace tendon::conformance {

inline constexpr auto kAsk = static_cast<MessageType>(0x101);
inline constexpr auto kTell = static_cast<MessageType>(0x102);
inline constexpr auto kKeep = static_cast<MessageType>(0x103);
inline constexpr auto kThrow = static_cast<MessageType>(0x104);
inline constexpr auto kDrop = static_cast<MessageType>(0x105);
inline constexpr std::chrono::milliseconds kLong = kTestTimeout;

struct Question {
  std::string text;
  double number = 0;
};

}  // namespace tendon::conformance

template <>
inline constexpr auto tendon::kPayload<tendon::conformance::Question> =
    tendon::Describe("test.Question", tendon::Field{"text", &tendon::conformance::Question::text},
                     tendon::Field{"number", &tendon::conformance::Question::number});

namespace tendon::conformance {

/// Answers a Question: doubles its text and sets its number to the handle of the request. The type
/// of a request can demand another behaviour: keep it, drop it, or throw. Records all notices.
class Oracle final : public ChannelHandler {
 public:
  void OnOpen(const std::shared_ptr<Channel>& channel, const Hello& peer) override {
    const std::scoped_lock lock(mutex_);
    channel_ = channel;
    peer_ = peer.name;
    changed_.notify_all();
  }

  void OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                 std::span<const std::byte> body, Responder responder) override {
    if (header.type == kThrow) throw std::runtime_error("the oracle is tired");
    if (header.type == kDrop) return;
    if (header.type == kKeep) {
      const std::scoped_lock lock(mutex_);
      kept_.push_back(std::move(responder));
      changed_.notify_all();
      return;
    }
    if (header.type != kAsk) {
      return ChannelHandler::OnRequest(channel, header, body, std::move(responder));
    }
    auto question = DecodeBody<Question>(body);
    if (!question) return responder.Refuse(question.error());
    if (question->text.empty()) {
      return responder.ReplyWith<Question>(Error{ErrorCode::kNotFound, "there is no question"});
    }
    question->text += question->text;
    question->number = header.handle;
    responder.ReplyWith(question);
  }

  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                std::span<const std::byte> body) override {
    if (header.type == kThrow) throw 7;
    const auto question = DecodeBody<Question>(body);
    const std::scoped_lock lock(mutex_);
    if (question) told_.push_back(question->text);
    changed_.notify_all();
  }

  void OnClosed(const std::shared_ptr<Channel>& /*channel*/, const Error& reason) override {
    const std::scoped_lock lock(mutex_);
    closed_.push_back(reason);
    changed_.notify_all();
  }

  template <typename Condition>
  bool Wait(const Condition& condition) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kTestTimeout, [&] { return condition(*this); });
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::shared_ptr<Channel> channel_;
  std::string peer_;
  std::vector<Responder> kept_;
  std::vector<std::string> told_;
  std::vector<Error> closed_;
};

}  // namespace tendon::conformance
