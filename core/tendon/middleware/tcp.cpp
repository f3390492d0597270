#include <tendon/middleware/tcp.h>

#include <tendon/base/clock.h>
#include <tendon/base/os/poller.h>
#include <tendon/base/os/thread.h>
#include <tendon/base/rate_limited_warning.h>
#include <tendon/middleware/connect_cancellation.h>

#include <cassert>
#include <future>
#include <map>
#include <mutex>
#include <new>
#include <thread>
#include <utility>
#include <vector>

namespace tendon {
namespace {

using Watch = os::Poller::Watch;

constexpr const char* kOutOfMemory = "out of memory (ulimit -v): ";

/// An object that owns a socket. Its functions are called in the loop's thread.
class SocketOwner {
 public:
  virtual ~SocketOwner() = default;
  virtual void OnReady(bool readable, bool writable) = 0;
  virtual void OnTick(SteadyTime now) = 0;
  /// Called after a function of this object has thrown std::bad_alloc.
  virtual void OnOutOfMemory() = 0;
  virtual void CloseNow() = 0;
  /// The key of the listener that accepted the link; 0 for other objects.
  [[nodiscard]] virtual std::uint64_t endpoint() const { return 0; }
};

/// The thread of a TCP middleware, which serves all its sockets.
class EventLoop {
 public:
  using Key = std::uint64_t;
  EventLoop() : thread_([this] { Run(); }) {}
  [[nodiscard]] os::Poller& poller() { return poller_; }
  [[nodiscard]] RateLimitedWarning& warnings() { return warnings_; }
  /// A buffer for received bytes. May be used only in the loop's thread.
  [[nodiscard]] std::span<std::byte> scratch() { return scratch_; }

  Key NewKey() {
    const std::scoped_lock lock(mutex_);
    return ++last_key_;
  }
  void Add(Key key, std::shared_ptr<SocketOwner> owner, const os::Socket& socket) {
    const std::scoped_lock lock(mutex_);
    owners_.emplace(key, std::move(owner));
    poller_.Add(socket, key, Watch::kReads);
  }
  void Remove(Key key, const os::Socket& socket) {
    const std::scoped_lock lock(mutex_);
    poller_.Remove(socket);
    owners_.erase(key);
  }
  std::map<Key, std::shared_ptr<SocketOwner>> owners() {
    const std::scoped_lock lock(mutex_);
    return owners_;
  }
  /// Executes `task` soon, in the loop's thread. Returns false after Stop().
  bool Post(std::function<void()> task) {
    const std::scoped_lock lock(mutex_);
    if (is_stopped_) return false;
    tasks_.push_back(std::move(task));
    poller_.Wake();
    return true;
  }

  /// Executes `task` in the loop's thread and waits until it is done. Does nothing after Stop().
  void Execute(const std::function<void()>& task) {
    assert(std::this_thread::get_id() != thread_.get_id());
    const auto done = std::make_shared<std::promise<void>>();
    const bool accepted = Post([&task, done] {
      Guarded(task);
      done->set_value();
    });
    if (accepted) done->get_future().wait();
  }

  void Stop() {
    Execute([this] {
      Guarded([this] {
        for (const auto& [key, one] : owners()) Guarded([&it = *one] { it.CloseNow(); });
      });
      const std::scoped_lock lock(mutex_);
      is_stopped_ = true;
    });
    thread_.join();
  }

  /// Calls `function`. Returns false if it throws std::bad_alloc.
  template <typename Function>
  static bool Guarded(const Function& function) {
    try {
      function();
      return true;
    } catch (const std::bad_alloc&) {
      return false;
    }
  }

 private:
  void Run() {
    constexpr std::chrono::milliseconds kTick{200};
    os::NameThisThread("tcp");
    SteadyTime next_tick = SteadyClock().Now() + kTick;
    while (RunTasks()) {
      for (const auto& event : poller_.Wait(kTick)) {
        const auto one = Find(event.key);
        if (one) Serve(*one, [&] { one->OnReady(event.readable, event.writable); });
      }
      const SteadyTime now = SteadyClock().Now();
      if (now < next_tick) continue;
      next_tick = now + kTick;
      Guarded([&] {
        for (const auto& [key, one] : owners()) Serve(*one, [&, &it = *one] { it.OnTick(now); });
      });
    }
  }

  /// Calls `function`, which uses the object `one`. A lack of memory affects only this object.
  template <typename Function>
  static void Serve(SocketOwner& one, const Function& function) {
    if (!Guarded(function)) Guarded([&one] { one.OnOutOfMemory(); });
  }

  bool RunTasks() {
    std::unique_lock lock(mutex_);
    while (!tasks_.empty()) {
      const auto tasks = std::exchange(tasks_, {});
      lock.unlock();
      for (const auto& task : tasks) Guarded(task);
      lock.lock();
    }
    return !is_stopped_;
  }

  std::shared_ptr<SocketOwner> Find(Key key) {
    const std::scoped_lock lock(mutex_);
    const auto found = owners_.find(key);
    return found == owners_.end() ? nullptr : found->second;
  }

  os::Poller poller_;
  RateLimitedWarning warnings_{"tcp"};
  Bytes scratch_ = Bytes(std::size_t{256} << 10U);
  std::mutex mutex_;
  Key last_key_ = 0;
  bool is_stopped_ = false;
  std::vector<std::function<void()>> tasks_;
  std::map<Key, std::shared_ptr<SocketOwner>> owners_;
  std::thread thread_;  // last, because it uses the other members
};

class TcpLink final : public Link,
                      public SocketOwner,
                      public std::enable_shared_from_this<TcpLink> {
 public:
  TcpLink(std::shared_ptr<EventLoop> loop, os::Socket socket, EventLoop::Key endpoint)
      : loop_(std::move(loop)),
        key_(loop_->NewKey()),
        endpoint_(endpoint),
        peer_(os::PeerAddress(socket)),
        local_(os::LocalAddress(socket)),
        deadline_(endpoint == 0 ? SteadyTime::max() : SteadyClock().Now() + kAdmissionTime),
        socket_(std::move(socket)) {}

  void Begin(std::shared_ptr<LinkHandler> handler) {
    handler_ = std::move(handler);
    loop_->Add(key_, shared_from_this(), socket_);
  }

  /// Called only in the loop's thread.
  void BeginAccepted(const AcceptLink& accept) {
    Begin(nullptr);
    try {
      handler_ = accept(shared_from_this());
    } catch (...) {
      CloseNow();
      throw;
    }
    if (!handler_) CloseNow();
  }

  Status Send(std::span<const std::byte> frame, Delivery /*delivery*/) override {
    if (!ReadWholeFrame(frame, kMaxPieceSize)) return Status::kInvalid;
    const std::scoped_lock lock(mutex_);
    if (!is_open()) return Status::kNotConnected;
    const std::size_t unsent = unsent_.size() - sent_;
    if (unsent != 0 && unsent + frame.size() > kSendWindow) return Status::kQueueFull;
    bool has_begun = false;
    if (unsent == 0) {
      const auto size = os::SendSome(socket_, frame);
      if (!size) return Status::kNotConnected;
      frame = frame.subspan(*size);
      if (frame.empty()) return Status::kQueued;
      has_begun = *size != 0;
      loop_->poller().Change(socket_, key_, Watch::kReadsAndWrites);
    }
    try {
      unsent_.insert(unsent_.end(), frame.begin(), frame.end());
    } catch (const std::bad_alloc&) {
      if (has_begun) BreakOff();
      throw;
    }
    return Status::kQueued;
  }

  void Admit() override {
    const std::scoped_lock lock(mutex_);
    if (!is_open()) return;
    state_ = State::kAdmitted;
    deadline_ = SteadyTime::max();
  }

  void Close() override {
    const std::scoped_lock lock(mutex_);
    if (!is_open()) return;
    state_ = State::kClosing;
    deadline_ = SteadyClock().Now() + std::chrono::milliseconds(750);
    loop_->Post(
        [self = shared_from_this(), is_unacknowledged = os::ResetIfUnacknowledged(socket_)] {
          is_unacknowledged ? self->CloseNow() : self->Flush();
        });
  }

  [[nodiscard]] std::string peer() const override { return peer_; }
  [[nodiscard]] std::string local() const override { return local_; }
  [[nodiscard]] EventLoop::Key endpoint() const override { return endpoint_; }

  void OnReady(bool readable, bool writable) override {
    if (writable) Flush();
    if (readable) Read();
  }

  void OnTick(SteadyTime now) override {
    if (os::IsPeerUnreachable(socket_)) {
      return Finish({ErrorCode::kUnreachable, peer_ + " cannot be reached any more"});
    }
    std::unique_lock lock(mutex_);
    if (now < deadline_) return;
    const bool is_unauthenticated = state_ == State::kUnauthenticated;
    lock.unlock();
    if (!is_unauthenticated) return CloseNow();
    Reject(NotAdmitted(peer_));
  }

  void OnOutOfMemory() override {
    rest_ = {};
    Reject(
        {ErrorCode::kFailed, kOutOfMemory + std::string("the link to ") + peer_ + " needed more"});
  }

  void CloseNow() override {
    Finish({ErrorCode::kUnreachable, "the connection to " + peer_ + " was closed by this program"});
  }

 private:
  enum class State { kUnauthenticated, kAdmitted, kClosing, kClosed };

  State state() {
    const std::scoped_lock lock(mutex_);
    return state_;
  }
  [[nodiscard]] bool is_open() const { return state_ < State::kClosing; }  // under the lock

  /// Closes the link because a frame was sent only in part. Nothing may be sent after it, because
  /// the peer would read the bytes as the rest of the frame. Called while the lock is held.
  void BreakOff() {
    state_ = State::kClosing;
    deadline_ = SteadyTime::min();
    os::ShutDown(socket_.descriptor());
  }

  void Flush() {
    const std::scoped_lock lock(mutex_);
    if (state_ == State::kClosed) return;
    const auto size = os::SendSome(socket_, std::span(unsent_).subspan(sent_));
    sent_ += size.value_or(0);  // Read() detects a broken connection
    if (sent_ == unsent_.size()) {
      unsent_ = {};
      sent_ = 0;
      loop_->poller().Change(socket_, key_, Watch::kReads);
      if (state_ == State::kClosing) os::ShutDownSending(socket_);
    } else if (sent_ > unsent_.size() / 2) {
      unsent_.erase(unsent_.begin(), unsent_.begin() + static_cast<std::ptrdiff_t>(sent_));
      sent_ = 0;
    }
  }

  void Read() {
    const auto received = os::ReceiveSome(socket_, loop_->scratch());
    const bool is_ending = state() >= State::kClosing;
    if (!received && is_ending) return CloseNow();
    if (!received) return Finish({ErrorCode::kUnreachable, peer_ + " closed the connection"});
    if (is_ending) return;
    if (rest_.empty()) {
      const auto rest = DeliverFrames(*received);
      rest_.assign(rest.begin(), rest.end());
    } else {
      rest_.insert(rest_.end(), received->begin(), received->end());
      const auto rest = DeliverFrames(rest_);
      rest_.erase(rest_.begin(), rest_.end() - static_cast<std::ptrdiff_t>(rest.size()));
      if (rest_.empty()) rest_ = {};
    }
  }

  /// Delivers the complete frames at the front and returns the remaining bytes.
  std::span<const std::byte> DeliverFrames(std::span<const std::byte> bytes) {
    for (State now = state(); bytes.size() >= FrameHeader::kSize && now < State::kClosing;
         now = state()) {
      const bool is_known = now == State::kAdmitted;
      const auto header =
          ReadFrameHeader(bytes, is_known ? kMaxPieceSize : kMaxUnauthenticatedFrameSize);
      if (!header) {
        Reject(NoFrame(peer_));
        return {};
      }
      const std::size_t size = FrameHeader::kSize + header->size;
      if (bytes.size() < size) break;
      handler_->OnFrame(bytes.first(size));
      bytes = bytes.subspan(size);
    }
    return bytes;
  }

  void Reject(const Error& reason) {
    loop_->warnings().Add(reason.message + ": closed");
    Finish(reason);
  }

  void Finish(const Error& reason) {
    std::unique_lock lock(mutex_);
    if (std::exchange(state_, State::kClosed) == State::kClosed) return;
    loop_->Remove(key_, socket_);
    socket_ = {};
    unsent_ = {};
    lock.unlock();
    const auto handler = std::exchange(handler_, nullptr);
    // Guarded, because other links must still be closed if this call throws.
    if (handler) EventLoop::Guarded([&] { handler->OnClosed(reason); });
  }

  const std::shared_ptr<EventLoop> loop_;
  const EventLoop::Key key_;
  const EventLoop::Key endpoint_;
  const std::string peer_;
  const std::string local_;

  // Used only in the loop's thread:
  std::shared_ptr<LinkHandler> handler_;
  Bytes rest_;  // received bytes of an incomplete frame

  std::mutex mutex_;
  State state_ = State::kUnauthenticated;
  SteadyTime deadline_;  // time limit for Admit(), or for the end of Close()
  os::Socket socket_;
  Bytes unsent_;  // the bytes from index sent_ on are not sent yet
  std::size_t sent_ = 0;
};

/// The listening socket.
class ListeningEndpoint final : public SocketOwner,
                                public std::enable_shared_from_this<ListeningEndpoint> {
 public:
  ListeningEndpoint(std::shared_ptr<EventLoop> loop, os::Socket socket, AcceptLink accept)
      : loop_(std::move(loop)),
        key_(loop_->NewKey()),
        socket_(std::move(socket)),
        accept_(std::move(accept)) {}

  void Begin() { loop_->Add(key_, shared_from_this(), socket_); }

  void OnReady(bool /*readable*/, bool /*writable*/) override {
    os::Socket connection;
    auto accepted = os::Accept(socket_, connection);
    for (; accepted == os::AcceptResult::kOne; accepted = os::Accept(socket_, connection)) {
      std::make_shared<TcpLink>(loop_, std::move(connection), key_)->BeginAccepted(accept_);
    }
    if (accepted != os::AcceptResult::kFailed) return;
    loop_->warnings().Add("too many open files (ulimit -n): new connections have to wait");
    loop_->poller().Change(socket_, key_, Watch::kNothing);
  }

  void OnTick(SteadyTime /*now*/) override {
    loop_->poller().Change(socket_, key_, Watch::kReads);  // ends a pause of accepting
  }

  void OnOutOfMemory() override {
    loop_->warnings().Add(std::string(kOutOfMemory) + "a new connection is refused");
  }

  void CloseNow() override {
    loop_->Remove(key_, socket_);
    socket_ = {};
    for (const auto& [key, one] : loop_->owners()) {
      if (one->endpoint() == key_) EventLoop::Guarded([&it = *one] { it.CloseNow(); });
    }
  }

 private:
  const std::shared_ptr<EventLoop> loop_;
  const EventLoop::Key key_;
  os::Socket socket_;
  const AcceptLink accept_;
};

class TcpMiddleware final : public Middleware {
 public:
  explicit TcpMiddleware(Exposure exposure)
      : exposure_(exposure), loop_(std::make_shared<EventLoop>()) {}
  ~TcpMiddleware() override { loop_->Stop(); }

  [[nodiscard]] std::string_view name() const override { return "tcp"; }

  Result<std::unique_ptr<Listener>> Listen(const std::string& address, AcceptLink accept) override {
    const auto place = ParseAllowedAddress(address, 0, exposure_);
    if (!place) return place.error();
    auto socket = os::ListenAt(place->host, place->port);
    if (!socket) return socket.error();
    const std::string where = os::LocalAddress(*socket);
    auto endpoint =
        std::make_shared<ListeningEndpoint>(loop_, *std::move(socket), std::move(accept));
    endpoint->Begin();
    WarnOfExposure(exposure_, "tcp");
    return MakeListener(where, [loop = loop_, endpoint = std::move(endpoint)] {
      loop->Execute([&] { endpoint->CloseNow(); });
    });
  }

  Result<std::shared_ptr<Link>> Open(const std::string& address,
                                     std::shared_ptr<LinkHandler> handler,
                                     std::chrono::milliseconds timeout) override {
    const auto place = ParseAllowedAddress(address, 1, exposure_);
    if (!place) return place.error();
    auto socket = os::ConnectTo(place->host, place->port, timeout, AreConnectsCancelled);
    if (!socket) return AreConnectsCancelled() ? ConnectCancelledError() : socket.error();
    auto link = std::make_shared<TcpLink>(loop_, *std::move(socket), 0);
    link->Begin(std::move(handler));
    return std::shared_ptr<Link>(std::move(link));
  }

 private:
  const Exposure exposure_;
  const std::shared_ptr<EventLoop> loop_;
};

}  // namespace

std::unique_ptr<Middleware> MakeTcpMiddleware(Exposure exposure) {
  return std::make_unique<TcpMiddleware>(exposure);
}

}  // namespace tendon
