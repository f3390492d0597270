#pragma once

#include <support/wait.h>
#include <tendon/middleware/middleware.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace tendon::conformance {

/// Longer than any action in these tests takes, even on a machine that stalls.
inline constexpr std::chrono::seconds kTestTimeout{60};

/// A frame with `number` as its handle, so that a test can identify it.
inline Bytes FrameOf(std::uint32_t number, std::size_t body_size = 8) {
  FrameHeader header;
  header.type = static_cast<MessageType>(0x100);
  header.handle = number;
  header.size = static_cast<std::uint32_t>(body_size);
  Bytes frame;
  WriteFrame(header, Bytes(body_size, static_cast<std::byte>(number)), frame);
  return frame;
}

/// A link's handler that records all frames and the end of the link.
class Recorder final : public LinkHandler {
 public:
  using Action = std::function<void(std::span<const std::byte>)>;

  Recorder() = default;
  explicit Recorder(Action on_frame) : on_frame_(std::move(on_frame)) {}

  void OnFrame(std::span<const std::byte> frame) override {
    if (on_frame_) on_frame_(frame);
    const std::scoped_lock lock(mutex_);
    const auto header = ReadWholeFrame(frame);
    intact_ = intact_ && header && closed_ == 0;
    if (header) numbers_.push_back(header->handle);
    bytes_ += frame.size();
    changed_.notify_all();
  }

  void OnClosed(const Error& reason) override {
    const std::scoped_lock lock(mutex_);
    ++closed_;
    reason_ = reason;
    changed_.notify_all();
  }

  bool WaitForFrames(std::size_t count) {
    return Wait([&] { return numbers_.size() >= count; });
  }
  bool WaitForClosed() {
    return Wait([&] { return closed_ > 0; });
  }

  std::vector<std::uint32_t> numbers() const { return Get(numbers_); }
  std::size_t bytes() const { return Get(bytes_); }
  int closed() const { return Get(closed_); }
  Error reason() const { return Get(reason_); }
  /// Returns true if every frame was valid and no frame came after the end.
  bool intact() const { return Get(intact_); }

 private:
  template <typename Condition>
  bool Wait(const Condition& condition) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kTestTimeout, condition);
  }
  template <typename T>
  T Get(const T& member) const {
    const std::scoped_lock lock(mutex_);
    return member;
  }

  const Action on_frame_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::uint32_t> numbers_;
  std::size_t bytes_ = 0;
  int closed_ = 0;
  Error reason_;
  bool intact_ = true;
};

/// Accepts links and keeps them, each with a recorder. The function that accept() returns may
/// outlive this object.
class Host {
 public:
  /// Whether the host admits each guest, or leaves it unauthenticated.
  enum class Guests { kAdmitted, kUnauthenticated };
  struct Guest {
    std::shared_ptr<Link> link;
    std::shared_ptr<Recorder> recorder;
  };
  using MakeRecorder = std::function<std::shared_ptr<Recorder>(const std::shared_ptr<Link>&)>;

  explicit Host(MakeRecorder make = nullptr) { guests_->make = std::move(make); }
  explicit Host(Guests kind) : kind_(kind) {}

  AcceptLink accept() {
    return [guests = guests_, kind = kind_](const std::shared_ptr<Link>& link) {
      if (kind == Guests::kAdmitted) link->Admit();
      auto recorder = guests->make ? guests->make(link) : std::make_shared<Recorder>();
      const std::scoped_lock lock(guests->mutex);
      guests->all.push_back({link, recorder});
      guests->changed.notify_all();
      return recorder;
    };
  }

  /// Returns the accepted link with this index; waits until it arrives.
  Guest guest(std::size_t index = 0) {
    std::unique_lock lock(guests_->mutex);
    const bool came =
        guests_->changed.wait_for(lock, kTestTimeout, [&] { return guests_->all.size() > index; });
    return came ? guests_->all[index] : Guest{};
  }
  std::size_t count() const {
    const std::scoped_lock lock(guests_->mutex);
    return guests_->all.size();
  }

 private:
  struct List {
    MakeRecorder make;
    std::mutex mutex;
    std::condition_variable changed;
    std::vector<Guest> all;
  };
  const std::shared_ptr<List> guests_ = std::make_shared<List>();
  const Guests kind_ = Guests::kAdmitted;
};

}  // namespace tendon::conformance
