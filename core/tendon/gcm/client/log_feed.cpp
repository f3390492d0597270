#include <tendon/gcm/client/log_feed.h>

#include <algorithm>
#include <utility>

namespace tendon::client {

message::WatchLog LogFeed::Wanted() const {
  const std::scoped_lock lock(mutex_);
  return {gcm_instance_, next_};
}

LogBatch LogFeed::Begin(const message::WatchLogReply& watched) {
  const std::scoped_lock lock(mutex_);
  gcm_instance_ = watched.gcm_instance;
  next_ = watched.begin;
  current_ = watched.end;
  return {.records = {}, .lost = 0, .is_current = next_ >= current_};
}

LogBatch LogFeed::Take(message::LogRecords batch) {
  const std::scoped_lock lock(mutex_);
  const std::uint64_t end = batch.before + batch.records.size();
  const bool goes_forward = end >= batch.before && end >= next_;
  if (!goes_forward) return {.records = {}, .lost = 0, .is_current = next_ >= current_};
  const std::uint64_t lost = batch.before - std::min(next_, batch.before);
  const std::uint64_t heard = next_ - std::min(batch.before, next_);
  batch.records.erase(batch.records.begin(),
                      batch.records.begin() + static_cast<std::ptrdiff_t>(heard));
  next_ = end;
  return {.records = std::move(batch.records), .lost = lost, .is_current = next_ >= current_};
}

}  // namespace tendon::client
