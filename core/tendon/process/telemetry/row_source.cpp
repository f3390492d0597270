#include <tendon/process/telemetry/row_source.h>

#include <tendon/base/log.h>
#include <tendon/process/ask.h>
#include <tendon/process/heartbeat.h>

#include <algorithm>
#include <utility>

namespace tendon {
namespace {

constexpr std::chrono::milliseconds kSourceOpenTimeout(1000);
constexpr std::chrono::milliseconds kSourceReplyTimeout(2000);
constexpr std::chrono::milliseconds kListenTimeout(5000);
constexpr std::chrono::seconds kBrokerRest(30);     // pause after a failed subscription
constexpr std::chrono::seconds kLongestSilence(5);  // normally, a topic sends twice a second

message::Subscribe RequestFor(const TableSubscription& wanted) {
  return {.component = wanted.component,
          .table = wanted.table,
          .columns = wanted.columns,
          .rows = wanted.rows};
}

}  // namespace

void RowSource::Add(const std::shared_ptr<RowSubscription>& subscription) {
  items_.emplace_back().subscription = subscription;
  RestoreAll();
}

void RowSource::Remove(const std::shared_ptr<RowSubscription>& subscription) {
  const Item* item = Find(subscription);
  if (item == nullptr) return;
  if (item->stage == Stage::kActive && channel_) Unsubscribe(*channel_, item->handle);
  std::erase_if(items_, [&](const Item& one) { return one.subscription == subscription; });
  if (items_.empty()) Close();
}

void RowSource::ReadPast(const std::shared_ptr<PastRowsReading>& reading) {
  const auto opened = Open(std::max(kSourceOpenTimeout, past_timeout_ / 2));
  opened ? AskForPastRows(channel_, reading) : reading->Fail(opened.error());
}

void RowSource::AskForPastRows(const std::shared_ptr<Channel>& channel,
                               const std::shared_ptr<PastRowsReading>& reading) {
  tendon::Ask<message::ReadRowsReply>(
      *worker_, channel, message::kReadRows, reading->NextRequest(), past_timeout_,
      [self = shared_from_this(), channel, reading](const Result<message::ReadRowsReply>& page) {
        if (!page) return reading->Fail(page.error());
        if (reading->Take(*page, self->clock())) self->AskForPastRows(channel, reading);
      });
}

ClockOffset RowSource::clock() {
  const std::scoped_lock lock(mutex_);
  return clock_;
}

void RowSource::Retry() {
  backoff_.Reset();
  RestoreAll();
}

void RowSource::Close() {
  for (Item& item : items_) item.reception = nullptr;
  if (const auto channel = std::exchange(channel_, nullptr)) channel->Close();
}

/// Requests all subscriptions that are not active.
void RowSource::RestoreAll() {
  if (items_.empty()) return;
  if (const auto opened = Open(kSourceOpenTimeout); !opened) {
    for (const Item& item : items_) item.subscription->Interrupt(opened.error());
    return RetryLater();
  }
  for (Item& item : items_) {
    if (item.stage == Stage::kWanted) Ask(item);
  }
}

Result<void> RowSource::Open(std::chrono::milliseconds timeout) {
  if (channel_ && channel_->is_open()) return {};
  const auto address = access_.resolve(process_);
  if (!address) return address.error();
  Hello hello = access_.hello;
  hello.wanted = process_;
  auto channel = Channel::Open(*access_.middleware, *address, hello, shared_from_this(), timeout);
  if (!channel) return channel.error();
  channel_ = *std::move(channel);
  {
    const std::scoped_lock lock(mutex_);
    active_.clear();  // subscriptions of the old channel are requested again
    clock_ = {};      // a process at another address may have another clock
  }
  for (Item& item : items_) {
    item.stage = Stage::kWanted;
    item.is_direct = false;
  }
  MeasureClock();
  return {};
}

/// Starts to ping the process. Each ping measures the clock of the process; the first ping does so
/// before any row arrives.
void RowSource::MeasureClock() {
  MonitorPeer(pulse_, channel_,
              [weak = weak_from_this()](SteadyTime sent, SteadyTime there, SteadyTime arrived) {
                const auto self = weak.lock();
                if (!self) return;
                const std::scoped_lock lock(self->mutex_);
                self->clock_.Add(sent, there, arrived);
              });
}

void RowSource::Ask(Item& item) {
  item.reception = nullptr;
  item.line = nullptr;
  const std::string broker = BrokerFor(item);
  broker.empty() ? RequestRows(item) : RequestTopic(item, broker);
}

void RowSource::RequestRows(Item& item) {
  item.stage = Stage::kRequested;
  tendon::Ask<message::SubscribeReply>(
      *worker_, channel_, message::kSubscribe, RequestFor(item.subscription->wanted()),
      kSourceReplyTimeout,
      [self = shared_from_this(), channel = channel_,
       subscription = item.subscription](const Result<message::SubscribeReply>& reply) {
        auto outcome = reply;
        if (reply) {  // before the first rows arrive
          const auto begun = self->Begin(*channel, subscription, *reply);
          if (!begun) outcome = begun.error();
        }
        self->worker_->Post([self, channel, subscription, outcome] {
          self->OnReply(channel, subscription, outcome);
        });
      });
}

std::string RowSource::BrokerFor(const Item& item) const {
  const bool may_come = !item.is_direct && item.subscription->wanted().rows == RowChoice{} &&
                        access_.find_broker && access_.middleware->broadcast() != nullptr;
  if (!may_come) return {};
  const auto found = access_.find_broker();
  return found && !HasFailedRecently(*found) ? *found : std::string();
}

bool RowSource::HasFailedRecently(const std::string& broker) const {
  const auto failed = access_.failed_brokers->find(broker);
  return failed != access_.failed_brokers->end() &&
         SteadyClock().Now() - failed->second < kBrokerRest;
}

void RowSource::RequestTopic(Item& item, const std::string& broker) {
  item.stage = Stage::kRequested;
  tendon::Ask<message::JoinTopicReply>(
      *worker_, channel_, message::kJoinTopic, RequestFor(item.subscription->wanted()),
      kSourceReplyTimeout,
      [self = shared_from_this(), channel = channel_, subscription = item.subscription,
       broker](const Result<message::JoinTopicReply>& reply) {
        self->worker_->Post([self, channel, subscription, broker, reply] {
          self->OnTopicJoined(channel, subscription, broker, reply);
        });
      });
}

void RowSource::OnTopicJoined(const std::shared_ptr<Channel>& channel,
                              const SharedSubscription& subscription, const std::string& broker,
                              const Result<message::JoinTopicReply>& reply) {
  Item* item = Find(subscription);
  const bool is_void = item == nullptr || channel != channel_;
  if (is_void) {
    if (reply) Unsubscribe(*channel, reply->subscribed.handle);
    return;
  }
  if (!reply) return FallBack(*item, reply.error());
  if (const auto followed = Follow(*item, broker, *reply); !followed) {
    Unsubscribe(*channel, reply->subscribed.handle);
    FallBack(*item, followed.error());
  }
}

/// Subscribes at the broker. Messages are ignored until the subscription has begun. The
/// subscription begins with the next message after that.
Result<void> RowSource::Follow(Item& item, const std::string& broker,
                               const message::JoinTopicReply& joined) {
  if (HasFailedRecently(broker)) {  // another subscription has failed
    return Error{ErrorCode::kUnreachable, "the broker at " + broker + " has just failed"};
  }
  const auto line = std::make_shared<TopicState>();
  const auto hear = [weak = weak_from_this(), line,
                     subscription = item.subscription](std::span<const std::byte> body) {
    const TopicState::MessageScope hearing(*line);
    const auto self = weak.lock();
    const std::uint64_t beginning = line->beginning();
    if (!self || beginning == 0) return;
    std::unique_lock lock(self->mutex_);
    const ClockOffset clock = self->clock_;
    lock.unlock();
    subscription->Deliver(beginning, body, clock);
  };
  auto reception =
      access_.middleware->broadcast()->Subscribe(broker, joined.topic, hear, kListenTimeout);
  if (!reception) {
    (*access_.failed_brokers)[broker] = SteadyClock().Now();
    return reception.error();
  }
  const auto beginning =
      item.subscription->Begin(joined.subscribed, RowSubscription::Start::kFirstBatch);
  if (!beginning) return beginning.error();
  {
    const std::scoped_lock lock(mutex_);
    active_[{channel_.get(), joined.subscribed.handle}] = {
        .subscription = item.subscription, .beginning = *beginning, .line = line};
  }
  line->Begin(*beginning);
  item.stage = Stage::kActive;
  item.handle = joined.subscribed.handle;
  item.line = line;
  item.reception = *std::move(reception);
  backoff_.Reset();
  MonitorTopic(item.subscription, line);
  return {};
}

void RowSource::MonitorTopic(const SharedSubscription& subscription,
                             const std::shared_ptr<TopicState>& line) {
  worker_->PostAfter(kLongestPause, [self = shared_from_this(), subscription, line] {
    Item* item = self->Find(subscription);
    if (item == nullptr || item->line != line || !self->channel_) return;
    if (line->silence() < kLongestSilence) return self->MonitorTopic(subscription, line);
    const Error silent{ErrorCode::kUnreachable, "the broker has delivered nothing for 5 s"};
    self->Unsubscribe(*self->channel_, item->handle);
    subscription->Interrupt(silent);
    self->FallBack(*item, silent);
  });
}

void RowSource::FallBack(Item& item, const Error& reason) {
  if (std::exchange(fallen_back_, reason.message) != reason.message) {
    Log(LogLevel::kWarning, "telemetry",
        "rows of " + process_ + " are now sent without the broker: " + reason.message);
  }
  item.is_direct = true;
  Ask(item);
}

Result<void> RowSource::Begin(Channel& channel,
                              const std::shared_ptr<RowSubscription>& subscription,
                              const message::SubscribeReply& subscribed) {
  const auto beginning = subscription->Begin(subscribed);
  if (!beginning) {
    Unsubscribe(channel, subscribed.handle);
    return beginning.error();
  }
  const std::scoped_lock lock(mutex_);
  active_[{&channel, subscribed.handle}] = {.subscription = subscription, .beginning = *beginning};
  return {};
}

void RowSource::OnReply(const std::shared_ptr<Channel>& channel,
                        const std::shared_ptr<RowSubscription>& subscription,
                        const Result<message::SubscribeReply>& reply) {
  Item* item = Find(subscription);
  const bool is_void = item == nullptr || channel != channel_;
  if (is_void) {
    if (reply) Unsubscribe(*channel, reply->handle);
    return;
  }
  if (reply) {
    item->stage = Stage::kActive;
    item->handle = reply->handle;
    backoff_.Reset();
    return;
  }
  item->stage = Stage::kWanted;
  subscription->Interrupt(reply.error());
  RetryLater();
}

void RowSource::OnNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                         std::span<const std::byte> body) {
  if (header.type == message::kRowsEnded) {
    const auto ended = Take(channel.get(), header.handle);
    if (!ended) return;
    ended->Interrupt(ReadRefusal(body, process_));
    worker_->Post([self = shared_from_this(), ended] {
      Item* item = self->Find(ended);
      if (item == nullptr) return;
      item->stage = Stage::kWanted;
      self->RetryLater();
    });
    return;
  }
  if (header.type == message::kRows) OnRows(*channel, header.handle, body);
}

void RowSource::OnRows(Channel& channel, std::uint32_t handle, std::span<const std::byte> body) {
  std::unique_lock lock(mutex_);
  const auto found = active_.find({&channel, handle});
  if (found == active_.end()) {  // the subscription has ended, or the reply came too late
    lock.unlock();
    (void)channel.Notify(message::kUnsubscribe, handle, Bytes());
    return;
  }
  const ActiveSubscription standing = found->second;
  const ClockOffset clock = clock_;
  lock.unlock();
  standing.subscription->Deliver(standing.beginning, body, clock);
  // The process sends no more rows until this acknowledgement arrives. If it cannot be sent, the
  // channel is closed, and the next channel subscribes again.
  const bool must_tell = standing.subscription->wanted().rows.delivery == RowDelivery::kNewest;
  if (must_tell && !channel.Notify(message::kRowTaken, handle, Bytes())) channel.Close();
}

void RowSource::OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason) {
  std::vector<std::shared_ptr<RowSubscription>> interrupted;
  {
    const std::scoped_lock lock(mutex_);
    std::erase_if(active_, [&](const auto& one) {
      if (one.first.first != channel.get()) return false;
      if (one.second.line) one.second.line->End();
      interrupted.push_back(one.second.subscription);
      return true;
    });
  }
  const Error lost{ErrorCode::kUnreachable,
                   "process '" + process_ + "' was lost: " + reason.message};
  for (const auto& subscription : interrupted) subscription->Interrupt(lost);
  worker_->Post([self = shared_from_this(), channel] {
    if (self->channel_ != channel) return;
    self->channel_ = nullptr;
    for (Item& item : self->items_) {
      item.stage = Stage::kWanted;
      item.reception = nullptr;
      item.line = nullptr;
    }
    self->RetryLater();
  });
}

void RowSource::Unsubscribe(Channel& channel, std::uint32_t handle) {
  Take(&channel, handle);
  (void)channel.Notify(message::kUnsubscribe, handle, Bytes());
}

void RowSource::RetryLater() {
  if (std::exchange(is_retry_due_, true)) return;
  worker_->PostAfter(backoff_.Next(), [self = shared_from_this()] {
    self->is_retry_due_ = false;
    self->RestoreAll();
  });
}

RowSource::Item* RowSource::Find(const std::shared_ptr<RowSubscription>& subscription) {
  const auto found = std::find_if(items_.begin(), items_.end(), [&](const Item& item) {
    return item.subscription == subscription;
  });
  return found == items_.end() ? nullptr : &*found;
}

std::shared_ptr<RowSubscription> RowSource::Take(const Channel* channel, std::uint32_t handle) {
  const std::scoped_lock lock(mutex_);
  const auto node = active_.extract({channel, handle});
  if (!node) return nullptr;
  if (node.mapped().line) node.mapped().line->End();
  return node.mapped().subscription;
}

}  // namespace tendon
