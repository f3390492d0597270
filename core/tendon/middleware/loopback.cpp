#include <tendon/base/os/thread.h>
#include <tendon/middleware/loopback.h>

#include <cassert>
#include <condition_variable>
#include <deque>
#include <set>
#include <thread>
#include <utility>

namespace tendon {
namespace loopback {

/// The one thread of a LoopbackMiddleware, and the ends of links that live in it.
class Courier {
 public:
  using Errand = std::function<void()>;

  Courier() : thread_([this] { Run(); }) {}
  Courier(const Courier&) = delete;
  Courier& operator=(const Courier&) = delete;
  ~Courier() { assert(!thread_.joinable()); }

  /// Does it soon, in order; false after Stop().
  bool Post(Errand errand) {
    const std::scoped_lock lock(mutex_);
    if (stopped_) return false;
    errands_.push_back(std::move(errand));
    changed_.notify_all();
    return true;
  }

  /// Until all that was posted before is done.
  void Flush() {
    assert(std::this_thread::get_id() != thread_.get_id());
    std::unique_lock lock(mutex_);
    const std::uint64_t target = done_ + errands_.size() + (busy_ ? 1 : 0);
    changed_.wait(lock, [&] { return done_ >= target; });
  }

  void Adopt(std::shared_ptr<End> end) {
    const std::scoped_lock lock(mutex_);
    ends_.insert(std::move(end));
  }
  void Forget(const std::shared_ptr<End>& end) {
    const std::scoped_lock lock(mutex_);
    ends_.erase(end);
  }
  std::set<std::shared_ptr<End>> ends() {
    const std::scoped_lock lock(mutex_);
    return ends_;
  }

  /// Of the courier's thread: whether links are still accepted.
  [[nodiscard]] bool is_closing() const { return is_closing_; }

  /// Closes every end; when it returns their handlers have heard it.
  void Stop();

 private:
  void Run() {
    os::NameThisThread("loopback");
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [&] { return stopped_ || !errands_.empty(); });
      if (errands_.empty()) return;
      {
        const Errand errand = std::move(errands_.front());
        errands_.pop_front();
        busy_ = true;
        lock.unlock();
        errand();
      }
      lock.lock();
      busy_ = false;
      ++done_;
      changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Errand> errands_;
  std::set<std::shared_ptr<End>> ends_;
  std::uint64_t done_ = 0;
  bool busy_ = false;
  bool stopped_ = false;
  bool is_closing_ = false;
  std::thread thread_;  // last: it uses the others
};

/// A listener as others see it.
struct Door {
  std::shared_ptr<Courier> courier;
  AcceptLink accept;
  bool is_open = true;  // of the courier's thread

  void Enter(const std::shared_ptr<End>& end);
  /// Closes the links that entered; when it returns their handlers have heard it.
  void Shut();
};

/// One end of a link; the two know each other.
class End final : public Link, public std::enable_shared_from_this<End> {
 public:
  End(std::shared_ptr<LoopbackNetwork> network, std::shared_ptr<Courier> courier, std::string local,
      std::string peer, const Door* door)
      : network_(std::move(network)),
        courier_(std::move(courier)),
        local_name_(std::move(local)),
        peer_name_(std::move(peer)),
        door_(door) {}

  void Begin(const std::shared_ptr<End>& other, std::shared_ptr<LinkHandler> handler) {
    other_ = other;
    handler_ = std::move(handler);
  }

  Status Send(std::span<const std::byte> frame) override { return Pass(frame, Kind::kSent); }
  Status Ask(std::span<const std::byte> frame) override { return Pass(frame, Kind::kAsked); }

  void Admit() override {
    const std::scoped_lock lock(mutex_);
    limit_ = kMaxFrameSize;
  }

  void Close() override {
    CloseFor({ErrorCode::kUnreachable, "the connection to " + peer_name_ + " was closed here"});
  }

  [[nodiscard]] std::string peer() const override { return peer_name_; }
  [[nodiscard]] std::string local() const override { return local_name_; }
  [[nodiscard]] const Door* door() const { return door_; }

  /// In the courier's thread, before anything else is.
  void SetHandler(std::shared_ptr<LinkHandler> handler) { handler_ = std::move(handler); }

 private:
  /// What a frame is to who gets it; a question's answer needs no room on the link.
  enum class Kind { kSent, kAsked, kAnswer };

  Status Pass(std::span<const std::byte> frame, Kind kind) {
    if (!ReadWholeFrame(frame)) return Status::kInvalid;
    const auto other = other_.lock();
    if (!other || !IsOpen()) return Status::kNotConnected;
    if (!network_->Passes(frame)) return Status::kQueued;
    return other->Take(frame, kind);
  }

  bool IsOpen() {
    const std::scoped_lock lock(mutex_);
    return !has_ended_;
  }

  Status Take(std::span<const std::byte> frame, Kind kind) {
    const std::scoped_lock lock(mutex_);
    if (has_ended_) return Status::kNotConnected;
    const bool is_full = waiting_ != 0 && waiting_ + frame.size() > kSendWindow;
    if (is_full && kind != Kind::kAnswer) return Status::kQueueFull;
    waiting_ += frame.size();
    courier_->Post([self = shared_from_this(), copy = Bytes(frame.begin(), frame.end()), kind] {
      self->Deliver(copy, kind);
    });
    return Status::kQueued;
  }

  void CloseFor(const Error& reason) {
    {
      const std::scoped_lock lock(mutex_);
      is_deaf_ = true;
    }
    Finish(reason);
    if (const auto other = other_.lock()) {
      other->Finish({ErrorCode::kUnreachable, other->peer_name_ + " closed the connection"});
    }
  }

  void Deliver(const Bytes& frame, Kind kind) {
    std::unique_lock lock(mutex_);
    waiting_ -= frame.size();
    if (is_deaf_) return;
    const bool fits = frame.size() <= limit_;
    lock.unlock();
    if (!fits) return CloseFor(NoFrame(peer_name_));
    if (!handler_) return;
    if (kind != Kind::kAsked) return handler_->OnFrame(frame);
    Bytes answer;
    handler_->OnAsked(frame, answer);
    if (!answer.empty()) (void)Pass(answer, Kind::kAnswer);
  }

  /// After what was posted before, the handler hears OnClosed().
  void Finish(const Error& reason) {
    const std::scoped_lock lock(mutex_);
    if (std::exchange(has_ended_, true)) return;
    courier_->Post([self = shared_from_this(), reason] {
      self->courier_->Forget(self);
      if (const auto handler = std::exchange(self->handler_, nullptr)) handler->OnClosed(reason);
    });
  }

  const std::shared_ptr<LoopbackNetwork> network_;
  const std::shared_ptr<Courier> courier_;
  const std::string local_name_;
  const std::string peer_name_;
  const Door* const door_;  // that accepted it, or null; never followed
  std::weak_ptr<End> other_;
  std::shared_ptr<LinkHandler> handler_;

  std::mutex mutex_;
  std::size_t limit_ = kMaxStrangersFrameSize;
  std::size_t waiting_ = 0;  // bytes that were sent and not delivered
  bool is_deaf_ = false;     // closed from this end: delivers nothing more
  bool has_ended_ = false;   // closed from either end: takes nothing more
};

void Courier::Stop() {
  Post([this] {
    is_closing_ = true;
    for (const auto& end : ends()) end->Close();
  });
  Flush();  // closes them
  Flush();  // and they hear it
  {
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
    changed_.notify_all();
  }
  thread_.join();
  ends_.clear();
}

void Door::Enter(const std::shared_ptr<End>& end) {
  std::shared_ptr<LinkHandler> handler;
  courier->Adopt(end);
  if (is_open && !courier->is_closing()) handler = accept(end);
  end->SetHandler(handler);
  if (!handler) end->Close();
}

void Door::Shut() {
  courier->Post([this] {
    is_open = false;
    for (const auto& end : courier->ends()) {
      if (end->door() == this) end->Close();
    }
  });
  courier->Flush();  // closes them
  courier->Flush();  // and they hear it
}

}  // namespace loopback

void LoopbackNetwork::SetFilter(Filter filter) {
  const std::scoped_lock lock(mutex_);
  filter_ = std::move(filter);
}

bool LoopbackNetwork::Passes(std::span<const std::byte> frame) {
  std::unique_lock lock(mutex_);
  if (!filter_) return true;
  const Filter filter = filter_;
  lock.unlock();
  return filter(frame);
}

bool LoopbackNetwork::Add(HostPort& address, const std::shared_ptr<loopback::Door>& door) {
  const std::scoped_lock lock(mutex_);
  if (address.port != 0) return doors_.emplace(ToString(address), door).second;
  do {
    address.port = static_cast<std::uint16_t>(++last_port_);
  } while (address.port == 0 || !doors_.emplace(ToString(address), door).second);
  return true;
}

void LoopbackNetwork::Remove(const std::string& address) {
  const std::scoped_lock lock(mutex_);
  doors_.erase(address);
}

std::shared_ptr<loopback::Door> LoopbackNetwork::Find(const std::string& address) {
  const std::scoped_lock lock(mutex_);
  const auto found = doors_.find(address);
  return found == doors_.end() ? nullptr : found->second;
}

std::string LoopbackNetwork::NameOfNextCaller() {
  const std::scoped_lock lock(mutex_);
  return "127.0.0.1:" + std::to_string(++last_port_ % 65536);
}

LoopbackMiddleware::LoopbackMiddleware(std::shared_ptr<LoopbackNetwork> network)
    : network_(std::move(network)), courier_(std::make_shared<loopback::Courier>()) {}

LoopbackMiddleware::~LoopbackMiddleware() { courier_->Stop(); }

Result<std::unique_ptr<Listener>> LoopbackMiddleware::Listen(const std::string& address,
                                                             AcceptLink accept) {
  auto place = ParseAddress(address, 0);
  if (!place) return place.error();
  auto door = std::make_shared<loopback::Door>();
  door->courier = courier_;
  door->accept = std::move(accept);
  if (!network_->Add(*place, door)) {
    return Error{ErrorCode::kExists, address + " is in use by another program"};
  }
  const std::string where = ToString(*place);
  return MakeListener(where, [network = network_, door = std::move(door), where] {
    network->Remove(where);
    door->Shut();
  });
}

Result<std::shared_ptr<Link>> LoopbackMiddleware::Open(const std::string& address,
                                                       std::shared_ptr<LinkHandler> handler,
                                                       std::chrono::milliseconds /*timeout*/) {
  const auto place = ParseAddress(address, 1);
  if (!place) return place.error();
  const auto door = network_->Find(ToString(*place));
  if (!door) return Error{ErrorCode::kUnreachable, "nobody listens at " + address};
  const std::string caller = network_->NameOfNextCaller();
  const std::string called = ToString(*place);
  const auto here = std::make_shared<loopback::End>(network_, courier_, caller, called, nullptr);
  const auto there =
      std::make_shared<loopback::End>(network_, door->courier, called, caller, door.get());
  here->Begin(there, std::move(handler));
  there->Begin(here, nullptr);
  courier_->Adopt(here);
  if (!door->courier->Post([door, there] { door->Enter(there); })) {
    courier_->Forget(here);
    return Error{ErrorCode::kUnreachable, "nobody listens at " + address};
  }
  return std::shared_ptr<Link>(here);
}

}  // namespace tendon
