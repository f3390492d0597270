#include <tendon/middleware/loopback.h>
#include <tendon/middleware/loopback/courier.h>

#include <deque>
#include <utility>

namespace tendon {
namespace loopback {

/// The shared part of a listener.
struct Door {
  std::shared_ptr<Courier> courier;
  std::string address;
  AcceptLink accept;
  bool is_open = true;  // used only in the courier's thread

  void Enter(const std::shared_ptr<End>& end);
  /// Closes the links that it accepted. After the return, all their handlers have got OnClosed().
  void Shut();
};

/// A reply frame that waits to be delivered to the peer of `end`.
class LoopbackReply final : public ReplySlot {
 public:
  enum class When { kOnceAsked, kOnceLeft };
  LoopbackReply(std::shared_ptr<loopback::End> end, When when)
      : end_(std::move(end)), when_(when) {}

  void PassOn() const;

 private:
  std::optional<std::span<std::byte>> MakeRoom(const FrameHeader& header) override {
    frame_.resize(FrameHeader::kSize + header.size);
    const std::span<std::byte> frame = frame_;
    WriteHeader(header, frame.first<FrameHeader::kSize>());
    return frame.subspan(FrameHeader::kSize);
  }
  void Leave() override {
    if (when_ == When::kOnceLeft) PassOn();
  }
  std::unique_ptr<ReplySlot> MakeLater() override {
    return std::make_unique<LoopbackReply>(end_, When::kOnceLeft);
  }

  const std::shared_ptr<loopback::End> end_;
  const When when_;
  Bytes frame_;
};

/// One end of a link. Each end has a pointer to the other one.
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
  void Answer(std::span<const std::byte> frame) { (void)Pass(frame, Kind::kAnswer); }

  void Admit() override {
    const std::scoped_lock lock(mutex_);
    is_admitted_ = true;
  }

  void Close() override {
    CloseFor({ErrorCode::kUnreachable, "the connection to " + peer_name_ + " was closed here"});
  }

  [[nodiscard]] std::string peer() const override { return peer_name_; }
  [[nodiscard]] std::string local() const override { return local_name_; }
  [[nodiscard]] const Door* door() const { return door_; }

  /// Delivers the frames that were held.
  void Release() {
    const std::scoped_lock lock(mutex_);
    for (Late& late : late_) {
      if (late.due == kHeld) late.due = {};
    }
    Expect(SteadyClock().Now());
  }

  /// Stops sending and delivering; the other end gets OnClosed().
  void Crash() {
    {
      const std::scoped_lock lock(mutex_);
      is_deaf_ = true;
      is_dumb_ = true;
    }
    TellOther();
  }

  /// In the courier's thread, before any other call there.
  void SetHandler(std::shared_ptr<LinkHandler> handler) { handler_ = std::move(handler); }

 private:
  /// How a frame was sent. A reply to Ask() needs no room on the link.
  enum class Kind { kSent, kAsked, kAnswer };

  struct Late {
    Bytes frame;
    Kind kind = Kind::kSent;
    SteadyTime due;
  };
  /// The largest frame that an admitted peer may send.
  static constexpr std::size_t MostOf(Kind kind) {
    return kind == Kind::kAnswer ? kMaxFrameSize : kMaxPieceSize;
  }

  static constexpr SteadyTime kHeld = SteadyTime::max();

  Status Pass(std::span<const std::byte> frame, Kind kind) {
    if (!ReadWholeFrame(frame, MostOf(kind))) return Status::kInvalid;
    const auto other = other_.lock();
    if (!other || !IsOpen()) return Status::kNotConnected;
    const Verdict verdict =
        network_->Decide({.bytes = frame, .from = local_name_, .to = peer_name_});
    return verdict.fate == Fate::kDrop ? Status::kQueued : other->Take(frame, kind, verdict);
  }

  bool IsOpen() {
    const std::scoped_lock lock(mutex_);
    return !has_ended_ && !is_dumb_;
  }

  Status Take(std::span<const std::byte> frame, Kind kind, const Verdict& verdict) {
    const std::scoped_lock lock(mutex_);
    if (has_ended_) return Status::kNotConnected;
    const bool is_full = waiting_ != 0 && waiting_ + frame.size() > kSendWindow;
    if (is_full && kind != Kind::kAnswer) return Status::kQueueFull;
    waiting_ += frame.size();
    Bytes copy(frame.begin(), frame.end());
    const bool is_held = verdict.fate == Fate::kHold;
    if (late_.empty() && !is_held && verdict.delay.count() == 0) {
      courier_->Post([self = shared_from_this(), frame = std::move(copy), kind] {
        self->Deliver(frame, kind);
      });
      return Status::kQueued;
    }
    const SteadyTime due = is_held ? kHeld : SteadyClock().Now() + verdict.delay;
    late_.push_back({std::move(copy), kind, due});
    if (is_held) {
      network_->Remember(weak_from_this());
    } else {
      Expect(due);
    }
    return Status::kQueued;
  }

  void Expect(SteadyTime due) {
    courier_->PostAt(due, [self = shared_from_this()] { self->DeliverDue(); });
  }
  /// Delivers in order: a delayed frame delays all frames behind it.
  void DeliverDue() {
    while (true) {
      Late late;
      {
        const std::scoped_lock lock(mutex_);
        if (late_.empty() || late_.front().due > SteadyClock().Now()) return;
        late = std::move(late_.front());
        late_.pop_front();
      }
      Deliver(late.frame, late.kind);
    }
  }

  void CloseFor(const Error& reason) {
    {
      const std::scoped_lock lock(mutex_);
      is_deaf_ = true;
    }
    Finish(reason);
    TellOther();
  }
  void TellOther() {
    if (const auto other = other_.lock()) {
      other->Finish({ErrorCode::kUnreachable, other->peer_name_ + " closed the connection"});
    }
  }

  void Deliver(const Bytes& frame, Kind kind) {
    std::unique_lock lock(mutex_);
    waiting_ -= frame.size();
    if (is_deaf_) return;
    const bool fits = frame.size() <= (is_admitted_ ? MostOf(kind) : kMaxStrangersFrameSize);
    lock.unlock();
    if (!fits) return CloseFor(NoFrame(peer_name_));
    if (!handler_) return;
    if (kind != Kind::kAsked) return handler_->OnFrame(frame);
    LoopbackReply answer(shared_from_this(), LoopbackReply::When::kOnceAsked);
    handler_->OnAsked(frame, answer);
    if (answer.is_there()) answer.PassOn();
  }

  /// Calls OnClosed() after everything that was posted before.
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
  const Door* const door_;  // its listener, or null; only compared, never dereferenced
  std::weak_ptr<End> other_;
  std::shared_ptr<LinkHandler> handler_;

  std::mutex mutex_;
  bool is_admitted_ = false;
  std::size_t waiting_ = 0;  // bytes sent and not yet delivered
  std::deque<Late> late_;    // still in the network
  bool is_deaf_ = false;     // closed at this end: delivers nothing more
  bool is_dumb_ = false;     // crashed: sends nothing more
  bool has_ended_ = false;   // closed at either end: accepts nothing more
};

void LoopbackReply::PassOn() const { end_->Answer(frame_); }

void Courier::Stop() {
  Post([this] {
    is_closing_.Set(true);
    for (const auto& end : ends()) end->Close();
  });
  Flush();  // closes the ends
  Flush();  // their handlers get OnClosed()
  {
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
    changed_.notify_all();
  }
  thread_.join();
  ends_.clear();
  later_.clear();
}

void Courier::Crash() {
  is_closing_.Set(true);
  for (const auto& end : ends()) end->Crash();
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
  courier->Flush();  // closes the ends
  courier->Flush();  // their handlers get OnClosed()
}

}  // namespace loopback

void LoopbackNetwork::SetJudge(Judge judge) {
  const std::scoped_lock lock(mutex_);
  judge_ = std::move(judge);
}

loopback::Verdict LoopbackNetwork::Decide(const loopback::Frame& frame) {
  std::unique_lock lock(mutex_);
  if (!judge_) return loopback::kPass;
  const Judge judge = judge_;
  lock.unlock();
  return judge(frame);
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

bool LoopbackNetwork::Add(HostPort& address, const std::shared_ptr<loopback::Door>& door) {
  const std::scoped_lock lock(mutex_);
  if (address.port != 0) return doors_.emplace(ToString(address), door).second;
  do {
    address.port = static_cast<std::uint16_t>(++last_port_);
  } while (address.port == 0 || !doors_.emplace(ToString(address), door).second);
  return true;
}

/// Does not remove an address that now belongs to another listener.
void LoopbackNetwork::Remove(const loopback::Door& door) {
  const std::scoped_lock lock(mutex_);
  const auto found = doors_.find(door.address);
  if (found != doors_.end() && found->second.get() == &door) doors_.erase(found);
}

void LoopbackNetwork::RemoveAll(const loopback::Courier& courier) {
  const std::scoped_lock lock(mutex_);
  std::erase_if(doors_, [&](const auto& one) { return one.second->courier.get() == &courier; });
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

void LoopbackMiddleware::Crash() {
  network_->RemoveAll(*courier_);
  courier_->Crash();
}

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
  door->address = ToString(*place);
  return MakeListener(door->address, [network = network_, door] {
    network->Remove(*door);
    door->Shut();
  });
}

Result<std::shared_ptr<Link>> LoopbackMiddleware::Open(const std::string& address,
                                                       std::shared_ptr<LinkHandler> handler,
                                                       std::chrono::milliseconds /*timeout*/) {
  const auto place = ParseAddress(address, 1);
  if (!place) return place.error();
  const auto door = network_->Find(ToString(*place));
  if (courier_->is_closing()) return Error{ErrorCode::kUnreachable, "this process has crashed"};
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
