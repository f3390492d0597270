#include <tendon/middleware/loopback.h>

#include <tendon/base/clock.h>
#include <tendon/base/os/thread.h>
#include <tendon/lockfree/flag.h>

#include <cassert>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

namespace tendon {
namespace loopback {

class End;

/// The thread of a LoopbackMiddleware. Also keeps the ends of its links.
class DeliveryThread {
 public:
  using Job = std::function<void()>;

  DeliveryThread() : thread_([this] { Run(); }) {}
  DeliveryThread(const DeliveryThread&) = delete;
  DeliveryThread& operator=(const DeliveryThread&) = delete;
  ~DeliveryThread() { assert(!thread_.joinable()); }

  /// Executes the job in this thread, after the jobs posted before. Returns false after Stop().
  bool Post(Job job) {
    const std::scoped_lock lock(mutex_);
    if (stopped_) return false;
    jobs_.push_back(std::move(job));
    changed_.notify_all();
    return true;
  }

  /// Executes the job at the time `due`. Does nothing after Stop().
  void PostAt(SteadyTime due, Job job) {
    const std::scoped_lock lock(mutex_);
    if (stopped_) return;
    later_.emplace(due, std::move(job));
    changed_.notify_all();
  }

  /// Waits until all jobs posted before are done.
  void Flush() {
    assert(std::this_thread::get_id() != thread_.get_id());
    std::unique_lock lock(mutex_);
    const std::uint64_t target = done_ + jobs_.size() + (busy_ ? 1 : 0);
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

  /// Returns true if no more links are accepted.
  [[nodiscard]] bool is_closing() const { return is_closing_.Get(); }

  /// Closes every end and ends the thread. All calls of OnClosed() have returned before this
  /// function returns.
  void Stop();
  /// See LoopbackMiddleware::Crash().
  void Crash();

 private:
  /// Moves delayed jobs that are due to the queue. Called while the mutex is held.
  void TakeDue() {
    const SteadyTime now = SteadyClock().Now();
    while (!later_.empty() && later_.begin()->first <= now) {
      jobs_.push_back(std::move(later_.begin()->second));
      later_.erase(later_.begin());
    }
  }
  void Await(std::unique_lock<std::mutex>& lock) {
    TakeDue();
    while (!stopped_ && jobs_.empty()) {
      if (later_.empty()) {
        changed_.wait(lock);
      } else {
        changed_.wait_until(lock, later_.begin()->first);
      }
      TakeDue();
    }
  }
  void Run() {
    os::NameThisThread("loopback");
    std::unique_lock lock(mutex_);
    while (true) {
      Await(lock);
      if (jobs_.empty()) return;
      {
        const Job job = std::move(jobs_.front());
        jobs_.pop_front();
        busy_ = true;
        lock.unlock();
        job();
      }
      lock.lock();
      busy_ = false;
      ++done_;
      changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Job> jobs_;
  std::multimap<SteadyTime, Job> later_;
  std::set<std::shared_ptr<End>> ends_;
  std::uint64_t done_ = 0;
  bool busy_ = false;
  bool stopped_ = false;
  Flag is_closing_{false};
  std::thread thread_;  // last, because it uses the other members
};

/// The part of a listener that it shares with its links.
struct ListeningEndpoint {
  std::shared_ptr<DeliveryThread> thread;
  std::string address;
  AcceptLink accept;
  bool is_open = true;  // used only in the delivery thread

  void Enter(const std::shared_ptr<End>& end);
  /// Closes the links that the listener has accepted. All calls of OnClosed() have returned before
  /// this function returns.
  void Close();
};

/// A slot for a reply frame that is delivered to the peer of `end`.
class LoopbackReply final : public ReplySlot {
 public:
  enum class DeliveryTime { kAfterRequest, kAtOnce };
  LoopbackReply(std::shared_ptr<loopback::End> end, DeliveryTime when)
      : end_(std::move(end)), when_(when) {}

  void Deliver() const;

 private:
  std::optional<std::span<std::byte>> MakeRoom(const FrameHeader& header) override {
    frame_.resize(FrameHeader::kSize + header.size);
    const std::span<std::byte> frame = frame_;
    WriteHeader(header, frame.first<FrameHeader::kSize>());
    return frame.subspan(FrameHeader::kSize);
  }
  void OnEnd() override {
    if (when_ == DeliveryTime::kAtOnce) Deliver();
  }
  std::unique_ptr<ReplySlot> MakeDeferred() override {
    return std::make_unique<LoopbackReply>(end_, DeliveryTime::kAtOnce);
  }

  const std::shared_ptr<loopback::End> end_;
  const DeliveryTime when_;
  Bytes frame_;
};

/// One end of a link. Each end has a pointer to the other end.
class End final : public Link, public std::enable_shared_from_this<End> {
 public:
  End(std::shared_ptr<LoopbackNetwork> network, std::shared_ptr<DeliveryThread> thread,
      std::string local, std::string peer, const ListeningEndpoint* endpoint)
      : network_(std::move(network)),
        thread_(std::move(thread)),
        local_name_(std::move(local)),
        peer_name_(std::move(peer)),
        endpoint_(endpoint) {}

  void Begin(const std::shared_ptr<End>& other, std::shared_ptr<LinkHandler> handler) {
    other_ = other;
    handler_ = std::move(handler);
  }

  Status Send(std::span<const std::byte> frame, Delivery delivery) override {
    return Transmit(frame, delivery == Delivery::kDirect ? Kind::kDirect : Kind::kQueued);
  }
  void Reply(std::span<const std::byte> frame) { (void)Transmit(frame, Kind::kReply); }

  void Admit() override {
    const std::scoped_lock lock(mutex_);
    is_admitted_ = true;
  }

  void Close() override {
    CloseFor({ErrorCode::kUnreachable,
              "the connection to " + peer_name_ + " was closed by this program"});
  }

  [[nodiscard]] std::string peer() const override { return peer_name_; }
  [[nodiscard]] std::string local() const override { return local_name_; }
  [[nodiscard]] const ListeningEndpoint* endpoint() const { return endpoint_; }

  /// Delivers the frames that were held.
  void Release() {
    const std::scoped_lock lock(mutex_);
    for (DelayedFrame& delayed : delayed_) {
      if (delayed.due == kHeld) delayed.due = {};
    }
    Expect(SteadyClock().Now());
  }

  /// Stops sending and delivering. OnClosed() is called at the other end.
  void Crash() {
    {
      const std::scoped_lock lock(mutex_);
      delivers_nothing_ = true;
      sends_nothing_ = true;
    }
    NotifyPeer();
  }

  /// Must be called in the delivery thread, before any other function is called in this thread.
  void SetHandler(std::shared_ptr<LinkHandler> handler) { handler_ = std::move(handler); }

 private:
  /// The way in which a frame was sent. A reply to a direct request is sent even if the link is
  /// full.
  enum class Kind { kQueued, kDirect, kReply };

  struct DelayedFrame {
    Bytes frame;
    Kind kind = Kind::kQueued;
    SteadyTime due;
  };
  /// The largest frame that an admitted peer may send.
  static constexpr std::size_t MostOf(Kind kind) {
    return kind == Kind::kReply ? kMaxFrameSize : kMaxPieceSize;
  }

  static constexpr SteadyTime kHeld = SteadyTime::max();

  Status Transmit(std::span<const std::byte> frame, Kind kind) {
    if (!ReadWholeFrame(frame, MostOf(kind))) return Status::kInvalid;
    const auto other = other_.lock();
    if (!other || !IsOpen()) return Status::kNotConnected;
    const Fault fault = network_->Decide({.bytes = frame, .from = local_name_, .to = peer_name_});
    return fault.action == FaultAction::kDrop ? Status::kQueued : other->Take(frame, kind, fault);
  }

  bool IsOpen() {
    const std::scoped_lock lock(mutex_);
    return !has_ended_ && !sends_nothing_;
  }

  Status Take(std::span<const std::byte> frame, Kind kind, const Fault& fault) {
    const std::scoped_lock lock(mutex_);
    if (has_ended_) return Status::kNotConnected;
    const bool is_full = waiting_ != 0 && waiting_ + frame.size() > kSendWindow;
    if (is_full && kind != Kind::kReply) return Status::kQueueFull;
    waiting_ += frame.size();
    Bytes copy(frame.begin(), frame.end());
    const bool is_held = fault.action == FaultAction::kHold;
    if (delayed_.empty() && !is_held && fault.delay.count() == 0) {
      thread_->Post([self = shared_from_this(), frame = std::move(copy), kind] {
        self->Deliver(frame, kind);
      });
      return Status::kQueued;
    }
    const SteadyTime due = is_held ? kHeld : SteadyClock().Now() + fault.delay;
    delayed_.push_back({std::move(copy), kind, due});
    if (is_held) {
      network_->Remember(weak_from_this());
    } else {
      Expect(due);
    }
    return Status::kQueued;
  }

  void Expect(SteadyTime due) {
    thread_->PostAt(due, [self = shared_from_this()] { self->DeliverDue(); });
  }
  /// Delivers the frames that are due, in order. A delayed frame also delays all later frames.
  void DeliverDue() {
    while (true) {
      DelayedFrame delayed;
      {
        const std::scoped_lock lock(mutex_);
        if (delayed_.empty() || delayed_.front().due > SteadyClock().Now()) return;
        delayed = std::move(delayed_.front());
        delayed_.pop_front();
      }
      Deliver(delayed.frame, delayed.kind);
    }
  }

  void CloseFor(const Error& reason) {
    {
      const std::scoped_lock lock(mutex_);
      delivers_nothing_ = true;
    }
    Finish(reason);
    NotifyPeer();
  }
  void NotifyPeer() {
    if (const auto other = other_.lock()) {
      other->Finish({ErrorCode::kUnreachable, other->peer_name_ + " closed the connection"});
    }
  }

  void Deliver(const Bytes& frame, Kind kind) {
    std::unique_lock lock(mutex_);
    waiting_ -= frame.size();
    if (delivers_nothing_) return;
    const bool fits = frame.size() <= (is_admitted_ ? MostOf(kind) : kMaxUnauthenticatedFrameSize);
    lock.unlock();
    if (!fits) return CloseFor(NoFrame(peer_name_));
    if (!handler_) return;
    if (kind != Kind::kDirect) return handler_->OnFrame(frame);
    LoopbackReply reply(shared_from_this(), LoopbackReply::DeliveryTime::kAfterRequest);
    handler_->OnDirectFrame(frame, reply);
    if (reply.is_there()) reply.Deliver();
  }

  /// Closes this end. OnClosed() is called after all frames that were posted before are delivered.
  void Finish(const Error& reason) {
    const std::scoped_lock lock(mutex_);
    if (std::exchange(has_ended_, true)) return;
    thread_->Post([self = shared_from_this(), reason] {
      self->thread_->Forget(self);
      if (const auto handler = std::exchange(self->handler_, nullptr)) handler->OnClosed(reason);
    });
  }

  const std::shared_ptr<LoopbackNetwork> network_;
  const std::shared_ptr<DeliveryThread> thread_;
  const std::string local_name_;
  const std::string peer_name_;
  const ListeningEndpoint* const endpoint_;  // null if not accepted; never dereferenced
  std::weak_ptr<End> other_;
  std::shared_ptr<LinkHandler> handler_;

  std::mutex mutex_;
  bool is_admitted_ = false;
  std::size_t waiting_ = 0;           // bytes sent but not delivered yet
  std::deque<DelayedFrame> delayed_;  // not delivered to the thread yet
  bool delivers_nothing_ = false;     // this end is closed
  bool sends_nothing_ = false;        // this end has crashed
  bool has_ended_ = false;            // one of the ends is closed
};

void LoopbackReply::Deliver() const { end_->Reply(frame_); }

void DeliveryThread::Stop() {
  Post([this] {
    is_closing_.Set(true);
    for (const auto& end : ends()) end->Close();
  });
  Flush();  // closes the ends
  Flush();  // calls OnClosed() of their handlers
  {
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
    changed_.notify_all();
  }
  thread_.join();
  ends_.clear();
  later_.clear();
}

void DeliveryThread::Crash() {
  is_closing_.Set(true);
  for (const auto& end : ends()) end->Crash();
}

void ListeningEndpoint::Enter(const std::shared_ptr<End>& end) {
  std::shared_ptr<LinkHandler> handler;
  thread->Adopt(end);
  if (is_open && !thread->is_closing()) handler = accept(end);
  end->SetHandler(handler);
  if (!handler) end->Close();
}

void ListeningEndpoint::Close() {
  thread->Post([this] {
    is_open = false;
    for (const auto& end : thread->ends()) {
      if (end->endpoint() == this) end->Close();
    }
  });
  thread->Flush();  // closes the ends
  thread->Flush();  // calls OnClosed() of their handlers
}

}  // namespace loopback

void LoopbackNetwork::SetFaultInjector(FaultInjector fault_injector) {
  const std::scoped_lock lock(mutex_);
  fault_injector_ = std::move(fault_injector);
}

loopback::Fault LoopbackNetwork::Decide(const loopback::Frame& frame) {
  std::unique_lock lock(mutex_);
  if (!fault_injector_) return loopback::kPass;
  const FaultInjector fault_injector = fault_injector_;
  lock.unlock();
  return fault_injector(frame);
}

void LoopbackNetwork::Remember(std::weak_ptr<loopback::End> holder) {
  const std::scoped_lock lock(mutex_);
  holders_.push_back(std::move(holder));
}

void LoopbackNetwork::ReleaseHeld() {
  std::vector<std::weak_ptr<loopback::End>> holders;
  {
    const std::scoped_lock lock(mutex_);
    holders.swap(holders_);
  }
  for (const auto& holder : holders) {
    if (const auto end = holder.lock()) end->Release();
  }
}

bool LoopbackNetwork::Add(HostPort& address,
                          const std::shared_ptr<loopback::ListeningEndpoint>& endpoint) {
  const std::scoped_lock lock(mutex_);
  if (address.port != 0) return endpoints_.emplace(ToString(address), endpoint).second;
  do {
    address.port = static_cast<std::uint16_t>(++last_port_);
  } while (address.port == 0 || !endpoints_.emplace(ToString(address), endpoint).second);
  return true;
}

/// Removes the address of the listener, unless the address now belongs to another listener.
void LoopbackNetwork::Remove(const loopback::ListeningEndpoint& endpoint) {
  const std::scoped_lock lock(mutex_);
  const auto found = endpoints_.find(endpoint.address);
  if (found != endpoints_.end() && found->second.get() == &endpoint) endpoints_.erase(found);
}

void LoopbackNetwork::RemoveAll(const loopback::DeliveryThread& thread) {
  const std::scoped_lock lock(mutex_);
  std::erase_if(endpoints_, [&](const auto& one) { return one.second->thread.get() == &thread; });
}

std::shared_ptr<loopback::ListeningEndpoint> LoopbackNetwork::Find(const std::string& address) {
  const std::scoped_lock lock(mutex_);
  const auto found = endpoints_.find(address);
  return found == endpoints_.end() ? nullptr : found->second;
}

std::string LoopbackNetwork::NameOfNextCaller() {
  const std::scoped_lock lock(mutex_);
  return "127.0.0.1:" + std::to_string(++last_port_ % 65536);
}

LoopbackMiddleware::LoopbackMiddleware(std::shared_ptr<LoopbackNetwork> network)
    : network_(std::move(network)), thread_(std::make_shared<loopback::DeliveryThread>()) {}

LoopbackMiddleware::~LoopbackMiddleware() { thread_->Stop(); }

void LoopbackMiddleware::Crash() {
  network_->RemoveAll(*thread_);
  thread_->Crash();
}

Result<std::unique_ptr<Listener>> LoopbackMiddleware::Listen(const std::string& address,
                                                             AcceptLink accept) {
  auto place = ParseAddress(address, 0);
  if (!place) return place.error();
  auto endpoint = std::make_shared<loopback::ListeningEndpoint>();
  endpoint->thread = thread_;
  endpoint->accept = std::move(accept);
  if (!network_->Add(*place, endpoint)) {
    return Error{ErrorCode::kExists, address + " is in use by another program"};
  }
  endpoint->address = ToString(*place);
  return MakeListener(endpoint->address, [network = network_, endpoint] {
    network->Remove(*endpoint);
    endpoint->Close();
  });
}

Result<std::shared_ptr<Link>> LoopbackMiddleware::Open(const std::string& address,
                                                       std::shared_ptr<LinkHandler> handler,
                                                       std::chrono::milliseconds /*timeout*/) {
  const auto place = ParseAddress(address, 1);
  if (!place) return place.error();
  const auto endpoint = network_->Find(ToString(*place));
  if (thread_->is_closing()) return Error{ErrorCode::kUnreachable, "this process has crashed"};
  if (!endpoint) return Error{ErrorCode::kUnreachable, "nobody listens at " + address};
  const std::string caller = network_->NameOfNextCaller();
  const std::string called = ToString(*place);
  const auto here = std::make_shared<loopback::End>(network_, thread_, caller, called, nullptr);
  const auto there =
      std::make_shared<loopback::End>(network_, endpoint->thread, called, caller, endpoint.get());
  here->Begin(there, std::move(handler));
  there->Begin(here, nullptr);
  thread_->Adopt(here);
  if (!endpoint->thread->Post([endpoint, there] { endpoint->Enter(there); })) {
    thread_->Forget(here);
    return Error{ErrorCode::kUnreachable, "nobody listens at " + address};
  }
  return std::shared_ptr<Link>(here);
}

}  // namespace tendon
