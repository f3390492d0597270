#include <tendon/process/ask.h>
#include <tendon/process/telemetry/row_source.h>
#include <tendon/process/watch_over.h>

#include <algorithm>
#include <utility>

namespace tendon {
namespace {

constexpr std::chrono::milliseconds kOpenTimeout(1000);
constexpr std::chrono::milliseconds kAnswerTimeout(2000);
constexpr std::chrono::milliseconds kShortestPause(100);
constexpr std::chrono::milliseconds kLongestPause(1000);

}  // namespace

void RowSource::Add(const std::shared_ptr<RowSubscription>& subscription) {
  items_.push_back({.subscription = subscription, .stage = Stage::kWanted, .handle = 0});
  Pursue();
}

void RowSource::Remove(const std::shared_ptr<RowSubscription>& subscription) {
  const Item* item = Find(subscription);
  if (item == nullptr) return;
  if (item->stage == Stage::kStanding && channel_) EndThere(*channel_, item->handle);
  std::erase_if(items_, [&](const Item& one) { return one.subscription == subscription; });
  if (items_.empty()) Close();
}

void RowSource::Retry() {
  pause_ = {};
  Pursue();
}

void RowSource::Close() {
  if (const auto channel = std::exchange(channel_, nullptr)) channel->Close();
}

/// Goes on with all that do not stand.
void RowSource::Pursue() {
  if (items_.empty()) return;
  if (const auto opened = Open(); !opened) {
    for (const Item& item : items_) item.subscription->Interrupt(opened.error());
    return RetryLater();
  }
  for (Item& item : items_) {
    if (item.stage == Stage::kWanted) Ask(item);
  }
}

Result<void> RowSource::Open() {
  if (channel_ && channel_->is_open()) return {};
  const auto address = access_.resolve(process_);
  if (!address) return address.error();
  Hello hello = access_.hello;
  hello.wanted = process_;
  auto channel =
      Channel::Open(*access_.middleware, *address, hello, shared_from_this(), kOpenTimeout);
  if (!channel) return channel.error();
  channel_ = *std::move(channel);
  {
    const std::scoped_lock lock(mutex_);
    standing_.clear();  // what stood on the channel before is asked for again
    clock_ = {};        // a process that has moved has another
  }
  for (Item& item : items_) item.stage = Stage::kWanted;
  MeasureClock();
  return {};
}

/// Each sign of life tells the time, the first before any rows come.
void RowSource::MeasureClock() {
  WatchOver(worker_, channel_,
            [weak = weak_from_this()](SteadyTime sent, SteadyTime there, SteadyTime arrived) {
              const auto self = weak.lock();
              if (!self) return;
              const std::scoped_lock lock(self->mutex_);
              self->clock_.Add(sent, there, arrived);
            });
}

void RowSource::Ask(Item& item) {
  item.stage = Stage::kAsked;
  const TableSubscription& wanted = item.subscription->wanted();
  tendon::Ask<message::Subscribed>(
      *worker_, channel_, message::kSubscribe,
      message::Subscribe{.component = wanted.component,
                         .table = wanted.table,
                         .columns = wanted.columns,
                         .rows = wanted.rows},
      kAnswerTimeout,
      [self = shared_from_this(), channel = channel_,
       subscription = item.subscription](const Result<message::Subscribed>& answer) {
        auto outcome = answer;
        if (answer) {  // before its first rows arrive
          const auto begun = self->Begin(*channel, subscription, *answer);
          if (!begun) outcome = begun.error();
        }
        self->worker_->Post([self, channel, subscription, outcome] {
          self->OnAnswer(channel, subscription, outcome);
        });
      });
}

Result<void> RowSource::Begin(Channel& channel,
                              const std::shared_ptr<RowSubscription>& subscription,
                              const message::Subscribed& subscribed) {
  const auto beginning = subscription->Begin(subscribed);
  if (!beginning) {
    EndThere(channel, subscribed.handle);
    return beginning.error();
  }
  const std::scoped_lock lock(mutex_);
  standing_[{&channel, subscribed.handle}] = {.subscription = subscription,
                                              .beginning = *beginning};
  return {};
}

void RowSource::OnAnswer(const std::shared_ptr<Channel>& channel,
                         const std::shared_ptr<RowSubscription>& subscription,
                         const Result<message::Subscribed>& answer) {
  Item* item = Find(subscription);
  const bool is_void = item == nullptr || channel != channel_;
  if (is_void) {
    if (answer) EndThere(*channel, answer->handle);
    return;
  }
  if (answer) {
    item->stage = Stage::kStanding;
    item->handle = answer->handle;
    pause_ = {};
    return;
  }
  item->stage = Stage::kWanted;
  subscription->Interrupt(answer.error());
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
  const auto found = standing_.find({&channel, handle});
  const bool is_known = found != standing_.end();  // or its answer is yet to come, or it has ended
  const Standing standing = is_known ? found->second : Standing{};
  const ClockOffset clock = clock_;
  lock.unlock();
  bool must_tell = true;
  if (is_known) {
    standing.subscription->Deliver(standing.beginning, body, clock);
    must_tell = standing.subscription->wanted().rows.delivery == RowDelivery::kNewest;
  }
  // Not told, the process would send no more; on a new channel it is asked again.
  if (must_tell && !channel.Notify(message::kRowTaken, handle, Bytes())) channel.Close();
}

void RowSource::OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason) {
  std::vector<std::shared_ptr<RowSubscription>> interrupted;
  {
    const std::scoped_lock lock(mutex_);
    std::erase_if(standing_, [&](const auto& one) {
      if (one.first.first != channel.get()) return false;
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
    for (Item& item : self->items_) item.stage = Stage::kWanted;
    self->RetryLater();
  });
}

void RowSource::EndThere(Channel& channel, std::uint32_t handle) {
  Take(&channel, handle);
  (void)channel.Notify(message::kUnsubscribe, handle, Bytes());
}

void RowSource::RetryLater() {
  if (std::exchange(is_retry_due_, true)) return;
  pause_ = std::clamp(2 * pause_, kShortestPause, kLongestPause);
  worker_->PostAfter(pause_, [self = shared_from_this()] {
    self->is_retry_due_ = false;
    self->Pursue();
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
  const auto node = standing_.extract({channel, handle});
  return node ? node.mapped().subscription : nullptr;
}

}  // namespace tendon
