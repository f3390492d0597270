#include <tendon/gcm/server/watchers.h>

#include <algorithm>

namespace tendon::server {
namespace {

constexpr std::size_t kLogLength = 1024;

}  // namespace

void Watchers::Add(const std::shared_ptr<Channel>& channel, std::uint64_t revision) {
  watchers_[channel.get()] = {.channel = channel, .revision = revision};
}

void Watchers::Remove(const Channel* channel) { watchers_.erase(channel); }

void Watchers::Publish(const std::vector<CatalogueChange>& changes) {
  for (const CatalogueChange& change : changes) {
    log_.push_back(change);
    newest_ = change.revision;
    if (log_.size() > kLogLength) log_.pop_front();
  }
  Pump();
}

void Watchers::Pump() {
  Batch batch;
  for (auto& [key, watcher] : watchers_) Pump(watcher, batch);
  DropSent();
}

/// Sends changes to one watcher until it has all changes or its link is full. A link refuses each
/// batch while its viewer does not read. Therefore, the batch gets smaller with each refusal, down
/// to one change, so that little work is wasted.
void Watchers::Pump(Watcher& watcher, Batch& batch) const {
  while (watcher.revision < newest_) {
    const bool is_too_much = batch.last - batch.after > watcher.most;
    if (batch.body.empty() || batch.after != watcher.revision || is_too_much) Fill(batch, watcher);
    if (!watcher.channel->Notify(message::kChanges, 0, batch.body)) {
      watcher.most = std::max<std::size_t>(watcher.most / 2, 1);
      return;
    }
    watcher.most = std::min(2 * watcher.most, kMaxInBatch);
    watcher.revision = batch.last;
  }
}

void Watchers::DropSent() {
  std::uint64_t sent = newest_;
  for (const auto& [key, watcher] : watchers_) sent = std::min(sent, watcher.revision);
  while (!log_.empty() && log_.front().revision <= sent) log_.pop_front();
}

void Watchers::Fill(Batch& batch, const Watcher& watcher) const {
  const std::uint64_t after = watcher.revision;
  message::Changes changes;
  if (after + 1 < log_.front().revision) {
    changes.changes.push_back(log_.back());
  } else {
    const auto first =
        log_.begin() + static_cast<std::ptrdiff_t>(after + 1 - log_.front().revision);
    const auto left = static_cast<std::size_t>(log_.end() - first);
    const auto count = static_cast<std::ptrdiff_t>(std::min(left, watcher.most));
    changes.changes.assign(first, first + count);
  }
  batch = {after, changes.changes.back().revision, EncodeBody(changes)};
}

}  // namespace tendon::server
