#include <tendon/gcm/client/gcm_link.h>

#include <tendon/base/os/process.h>
#include <tendon/gcm/lookup.h>
#include <tendon/process/guarded_handler.h>
#include <tendon/process/heartbeat.h>
#include <tendon/process/membership/advertised_address.h>

#include <map>
#include <utility>

namespace tendon::client {
namespace {

constexpr std::chrono::milliseconds kPause(100);  // pause before a broken channel is opened again
constexpr std::chrono::milliseconds kRetry(1000);
constexpr std::chrono::milliseconds kRenewal(1000);
constexpr std::chrono::milliseconds kTick(500);

/// Instance and address of each present process, by name.
using ProcessAddresses = std::map<std::string, std::pair<std::uint64_t, std::string>>;

ProcessAddresses AddressesOf(const Catalogue& catalogue) {
  ProcessAddresses addresses;
  for (const auto& [name, entry] : catalogue.processes()) {
    if (!IsPresent(entry.process)) continue;
    addresses[name] = {entry.process.instance, entry.process.address};
  }
  return addresses;
}

std::vector<GcmLink::MovedProcess> Moves(const ProcessAddresses& before,
                                         const ProcessAddresses& after) {
  std::vector<GcmLink::MovedProcess> moved;
  for (const auto& [name, address] : after) {
    const auto old = before.find(name);
    if (old == before.end() || old->second != address) moved.push_back({name, address.first});
  }
  return moved;
}

Error PauseError(std::chrono::nanoseconds pause) {
  const auto tenths = std::chrono::duration_cast<std::chrono::milliseconds>(pause).count() / 100;
  return {
      ErrorCode::kUnreachable,
      "this program was stopped, or got no processor time, for " + std::to_string(tenths / 10) +
          "." + std::to_string(tenths % 10) +
          " s, so the other processes closed its connections; it reconnects, but has missed the "
          "events of that time"};
}

}  // namespace

/// The handler of one channel to the GCM; each attempt to open a channel has a new one.
class GcmLink::Handler final : public ChannelHandler {
 public:
  explicit Handler(std::weak_ptr<GcmLink> link, Role role) : link_(std::move(link)), role_(role) {}

  void OnOpen(const SharedChannel& channel, const Hello& /*peer*/) override {
    LowerRole(*channel, role_);
    if (const auto link = link_.lock()) link->OnOpened(channel);
  }
  void OnNotice(const SharedChannel& channel, const FrameHeader& header,
                std::span<const std::byte> body) override {
    if (header.type == message::kChanges) Receive<message::Changes>(channel, body);
    if (header.type == message::kLogRecords) Receive<message::LogRecords>(channel, body);
  }
  void OnClosed(const SharedChannel& channel, const Error& reason) override {
    if (const auto link = link_.lock()) link->OnClosed(channel, reason);
  }

 private:
  template <Message T>
  void Receive(const SharedChannel& channel, std::span<const std::byte> body) {
    const auto link = link_.lock();
    if (!link) return;
    auto decoded = DecodeBody<T>(body);
    decoded ? link->Receive(channel, *std::move(decoded)) : channel->Close();
  }

  const std::weak_ptr<GcmLink> link_;
  const Role role_;
};

GcmLink::GcmLink(Middleware& middleware, GcmClient::Options options, Events events,
                 std::shared_ptr<Worker> timer)
    : middleware_(middleware),
      options_(std::move(options)),
      events_(std::move(events)),
      timer_(std::move(timer)) {}

void GcmLink::Start() {
  Tick();
  opener_.Post([this] { Open(); });
}

void GcmLink::Stop() {
  SharedChannel channel;
  {
    const std::scoped_lock telling(reporting_);
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
    channel = std::exchange(channel_, nullptr);
  }
  if (channel) channel->Close();
  opener_.Stop();
}

Result<void> GcmLink::WaitUntilWatching() {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, options_.timeout,
                    [this] { return !is_waiting_ || (lost_ && IsFinal(lost_->code)); });
  if (!is_waiting_) return {};
  return NoGcm();
}

/// Opens a channel. Called in the opener's thread.
void GcmLink::Open() {
  {
    const std::scoped_lock lock(mutex_);
    if (channel_) return;  // an earlier attempt has succeeded late
  }
  const auto cookie = LoopbackCookie();
  if (!cookie) {
    OnLost(cookie.error());
  } else {
    const Hello mine{.instance = os::RandomNumber(),
                     .name = options_.name,
                     .wanted = kGcmName,
                     .cookie = *cookie};
    const auto handler = std::make_shared<Handler>(weak_from_this(), options_.role);
    const auto channel =
        Channel::Open(middleware_, options_.address, mine, handler, options_.timeout);
    if (channel) return;  // OnOpen() of the handler continues
    OnLost(channel.error());
  }
  opener_.PostAfter(kRetry, [this] { Open(); });
}

void GcmLink::OnOpened(const SharedChannel& channel) {
  bool wants_log = false;
  {
    const std::scoped_lock lock(mutex_);
    if (stopped_) return channel->Close();
    channel_ = channel;
    wants_log = wants_log_;
  }
  Watch(channel);
  Renew(channel);
  if (wants_log) WatchLog(channel);
}

void GcmLink::Resync() {
  SharedChannel channel;
  {
    const std::scoped_lock lock(mutex_);
    if (is_waiting_) return;  // already requested
    is_waiting_ = true;
    channel = channel_;
  }
  Watch(channel);
}

void GcmLink::WatchLog() {
  SharedChannel channel;
  {
    const std::scoped_lock lock(mutex_);
    if (std::exchange(wants_log_, true)) return;
    channel = channel_;
  }
  if (channel) WatchLog(channel);
}

void GcmLink::OnClosed(const SharedChannel& channel, const Error& reason) {
  const std::scoped_lock lock(mutex_);
  if (channel_ != channel) return;
  channel_.reset();
  is_waiting_ = true;
  opener_.Post([this, reason] {
    OnLost(reason);
    opener_.PostAfter(kPause, [this] { Open(); });
  });
}

void GcmLink::Watch(const SharedChannel& channel) {
  Ask<message::CatalogueSnapshot>(*timer_, channel, message::kWatch, None{}, options_.timeout,
                                  [weak = weak_from_this(), channel](const auto& snapshot) {
                                    const auto self = weak.lock();
                                    if (!self) return;
                                    if (!snapshot) return channel->Close();
                                    self->Receive(channel, *snapshot);
                                  });
}

void GcmLink::WatchLog(const SharedChannel& channel) {
  Ask<message::WatchLogReply>(*timer_, channel, message::kWatchLog, log_.Wanted(), options_.timeout,
                              [weak = weak_from_this(), channel](const auto& watched) {
                                const auto self = weak.lock();
                                if (!self) return;
                                if (!watched) return channel->Close();
                                self->ReportLog(channel,
                                                [&] { return self->log_.Begin(*watched); });
                              });
}

void GcmLink::Receive(const SharedChannel& channel, message::CatalogueSnapshot snapshot) {
  ShareDescriptions(snapshot.changes);
  Catalogue catalogue = Catalogue::At(snapshot.base);
  for (const CatalogueChange& change : snapshot.changes) {
    if (!catalogue.Apply(change)) return channel->Close();
  }
  std::vector<MovedProcess> moved;
  std::chrono::nanoseconds pause{};
  {
    const std::scoped_lock lock(mutex_);
    if (channel_ != channel) return;
    pause = std::exchange(unreported_pause_, {});
    moved = Moves(AddressesOf(catalogue_), AddressesOf(catalogue));
    catalogue_ = catalogue;
    is_waiting_ = false;
    lost_.reset();
    changed_.notify_all();
  }
  Report([&] {
    if (events_.listener && pause > pause.zero()) events_.listener->OnGcmLost(PauseError(pause));
    if (events_.listener) events_.listener->OnSnapshot(catalogue);
    if (!moved.empty()) events_.on_moved(moved);
  });
}

void GcmLink::Receive(const SharedChannel& channel, message::Changes changes) {
  ShareDescriptions(changes.changes);
  std::vector<CatalogueChange> applied;
  std::vector<MovedProcess> moved;
  bool has_hole = false;
  {
    const std::scoped_lock lock(mutex_);
    if (channel_ != channel || is_waiting_) return;
    const ProcessAddresses before = AddressesOf(catalogue_);
    for (const CatalogueChange& change : changes.changes) {
      has_hole = !catalogue_.Apply(change);
      if (has_hole) break;
      applied.push_back(change);
    }
    moved = Moves(before, AddressesOf(catalogue_));
    is_waiting_ = has_hole;
  }
  Report([&] {
    if (events_.listener && !applied.empty()) events_.listener->OnChanges(applied);
    if (!moved.empty()) events_.on_moved(moved);
  });
  if (has_hole) Watch(channel);
}

/// Makes equal parts of component descriptions share memory, both within `changes` and with the
/// catalogue.
void GcmLink::ShareDescriptions(std::vector<CatalogueChange>& changes) {
  const std::scoped_lock lock(mutex_);
  for (CatalogueChange& change : changes) {
    for (ComponentDescription& component : change.components) pool_.Share(component);
  }
}

void GcmLink::Receive(const SharedChannel& channel, message::LogRecords records) {
  ReportLog(channel, [&] { return log_.Take(std::move(records)); });
}

/// Calls `take`, which returns a batch of the log, and passes the batch to the listener. Does
/// nothing if the channel is outdated.
template <typename Take>
void GcmLink::ReportLog(const SharedChannel& channel, Take&& take) {
  {
    const std::scoped_lock lock(mutex_);
    if (channel_ != channel) return;
  }
  const LogBatch batch = take();
  Report([&] {
    if (events_.listener) events_.listener->OnLog(batch);
  });
}

/// Pings the GCM every second, because a broken link is not always closed.
void GcmLink::Renew(const std::weak_ptr<Channel>& weak) {
  timer_->PostAfter(kRenewal, [self = weak_from_this(), weak] {
    const auto link = self.lock();
    const auto channel = weak.lock();
    if (!link || !channel || !channel->is_open()) return;
    Ask<None>(*link->timer_, channel, message::kRenew, None{}, link->options_.timeout,
              [self, channel](const auto& renewed) {
                if (!renewed) return channel->Close();
                if (const auto still_here = self.lock()) still_here->Renew(channel);
              });
  });
}

/// Detects when this program was suspended or got no CPU time, and for how long.
void GcmLink::Tick() {
  {
    const std::scoped_lock lock(mutex_);
    const SteadyTime now = SteadyClock().Now();
    const auto pause = now - std::exchange(last_tick_, now) - kTick;
    if (pause >= kLongestPeerSilence / 2) {
      awake_since_ = now;
      last_pause_ = pause;
    }
  }
  timer_->PostAfter(kTick, [weak = weak_from_this()] {
    if (const auto self = weak.lock()) self->Tick();
  });
}

/// Returns the length of a recent pause of this program; zero if there was no pause. After a pause,
/// peers may have closed their links. Called while the lock is held.
std::chrono::nanoseconds GcmLink::RecentPause() const {
  const SteadyTime now = SteadyClock().Now();
  if (now - last_tick_ >= kLongestPeerSilence) return now - last_tick_;
  return now - awake_since_ < 2 * kLongestPeerSilence ? last_pause_ : std::chrono::nanoseconds(0);
}

/// Called when the channel is lost or cannot be opened. Reports the loss once, not at each attempt.
/// After a pause of this program, the GCM is probably alive. Then nothing is reported until the GCM
/// has answered; after that, the pause is reported.
void GcmLink::OnLost(const Error& reason) {
  std::optional<Error> news;
  {
    const std::scoped_lock lock(mutex_);
    const auto pause = RecentPause();
    const bool is_new = !lost_ || IsFinal(lost_->code) != IsFinal(reason.code);
    if (is_new && pause >= kLongestPeerSilence / 2) {
      awake_since_ = {};
      last_tick_ = SteadyClock().Now();
      unreported_pause_ = pause;
    } else {
      unreported_pause_ = {};
      lost_ = reason;
      if (is_new) news = NoGcm();
    }
    changed_.notify_all();
  }
  if (!news || !events_.listener) return;
  Report([&] { events_.listener->OnGcmLost(*news); });
}

/// Returns the error for the time without a channel. Called while the lock is held.
Error GcmLink::NoGcm() const {
  if (lost_ && lost_->code != ErrorCode::kUnreachable && lost_->code != ErrorCode::kTimeout) {
    return *lost_;
  }
  return tendon::NoGcm(options_.address, lost_ ? lost_->message : "no program answers");
}

template <typename Call>
void GcmLink::Report(Call&& call) {
  const std::scoped_lock telling(reporting_);
  if (!stopped_) call();
}

}  // namespace tendon::client
