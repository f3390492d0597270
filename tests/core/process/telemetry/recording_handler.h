#pragma once

#include <gtest/gtest.h>
#include <tendon/middleware/channel.h>
#include <tendon/middleware/loopback.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

inline tendon::Hello HelloOf(const std::string& name) {
  return {.instance = 1, .name = name, .cookie = 4711};
}

/// One end of a channel that records its notices.
class RecordingHandler : public tendon::ChannelHandler {
 public:
  struct Notice {
    tendon::FrameHeader header;
    tendon::Bytes body;
  };

  void OnOpen(const std::shared_ptr<tendon::Channel>& opened,
              const tendon::Hello& /*peer*/) override {
    channel_.set_value(opened);
  }
  void OnNotice(const std::shared_ptr<tendon::Channel>& /*channel*/,
                const tendon::FrameHeader& header, std::span<const std::byte> body) override {
    is_at_gate = true;
    const std::scoped_lock held(gate);
    is_at_gate = false;
    const std::scoped_lock lock(mutex_);
    notices_.push_back({header, {body.begin(), body.end()}});
  }
  void OnClosed(const std::shared_ptr<tendon::Channel>& /*channel*/,
                const tendon::Error& /*reason*/) override {
    const std::scoped_lock lock(mutex_);
    is_closed_ = true;
  }

  std::shared_ptr<tendon::Channel> channel() { return channel_.get_future().get(); }
  std::vector<Notice> notices() const {
    const std::scoped_lock lock(mutex_);
    return notices_;
  }
  bool HasHeard(tendon::MessageType type, std::uint32_t handle) const {
    const std::scoped_lock lock(mutex_);
    return std::any_of(notices_.begin(), notices_.end(), [&](const Notice& one) {
      return one.header.type == type && one.header.handle == handle;
    });
  }
  bool is_closed() const {
    const std::scoped_lock lock(mutex_);
    return is_closed_;
  }

  std::mutex gate;  ///< a thread that delivers a notice waits while this is locked
  std::atomic<bool> is_at_gate{false};

 private:
  std::promise<std::shared_ptr<tendon::Channel>> channel_;
  mutable std::mutex mutex_;
  std::vector<Notice> notices_;
  bool is_closed_ = false;
};

/// A process and a viewer, with a channel over loopback between them.
class ProcessAndViewer {
 public:
  ProcessAndViewer() {
    auto listening = process_.Listen(
        "127.0.0.1:0", tendon::Channel::Acceptor(HelloOf("robot"), [this] { return feeding_; }));
    EXPECT_TRUE(listening.ok());
    listener_ = *std::move(listening);
    const auto opened = tendon::Channel::Open(viewer_, listener_->address(), HelloOf("viewer"),
                                              viewing, std::chrono::seconds(20));
    EXPECT_TRUE(opened.ok());
    channel = feeding_->channel();
  }

  const std::shared_ptr<RecordingHandler> viewing =
      std::make_shared<RecordingHandler>();  ///< the viewer's end
  std::shared_ptr<tendon::Channel> channel;  ///< the process' end

 private:
  const std::shared_ptr<RecordingHandler> feeding_ = std::make_shared<RecordingHandler>();
  const std::shared_ptr<tendon::LoopbackNetwork> network_ =
      std::make_shared<tendon::LoopbackNetwork>();
  tendon::LoopbackMiddleware process_{network_};
  tendon::LoopbackMiddleware viewer_{network_};
  std::unique_ptr<tendon::Listener> listener_;
};
