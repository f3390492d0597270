#include <tendon/gcm/server/log_buffer.h>

#include <tendon/base/text.h>
#include <tendon/gcm/text.h>

#include <algorithm>
#include <utility>

namespace tendon::server {
namespace {

constexpr std::uint64_t kMaxInBatch = 256;

message::LogRecord MissingRecords(const std::string& process, std::uint64_t count) {
  return {.time = WallTime(),
          .level = LogLevel::kWarning,
          .process = process,
          .source = "log",
          .text = Counted(count, "record was", "records were") + " lost on the way to the GCM"};
}

}  // namespace

void LogBuffer::Add(const std::string& process, std::uint64_t instance, message::LogRecords batch) {
  const auto [known, is_new] = senders_.try_emplace(process);
  Sender& sender = known->second;
  if (!is_new && sender.instance == instance && batch.before > sender.next) {
    Write(MissingRecords(process, batch.before - sender.next));
  }
  sender = {instance, batch.before + batch.records.size()};
  for (message::LogRecord& record : batch.records) {
    record.process = process;
    Write(std::move(record));
  }
}

void LogBuffer::AddOwn(message::LogRecord record) {
  record.process = kGcmName;
  Write(std::move(record));
}

message::WatchLogReply LogBuffer::Watch(const std::shared_ptr<Channel>& channel,
                                        std::uint64_t after) {
  const std::uint64_t begin = after == 0 ? first_ : std::min(after, end_);
  watchers_[channel.get()] = {channel, begin};
  return {.gcm_instance = 0, .begin = begin, .end = end_};
}

void LogBuffer::Pump() {
  Batch batch;
  for (auto& [key, watcher] : watchers_) Send(watcher, batch);
}

void LogBuffer::PumpAll() {
  for (auto& [key, watcher] : watchers_) watcher.is_full = false;
  Pump();
}

void LogBuffer::Send(Watcher& watcher, Batch& batch) const {
  while (watcher.next < end_ && !watcher.is_full) {
    const std::uint64_t begin = std::max(watcher.next, first_);
    if (batch.body.empty() || batch.begin != begin) batch = BatchFrom(begin);
    watcher.is_full = !watcher.channel->Notify(message::kLogRecords, 0, batch.body);
    if (!watcher.is_full) watcher.next = batch.end;
  }
}

LogBuffer::Batch LogBuffer::BatchFrom(std::uint64_t number) const {
  const std::uint64_t end = std::min(end_, number + kMaxInBatch);
  const auto from = records_.begin() + static_cast<std::ptrdiff_t>(number - first_);
  const auto to = records_.begin() + static_cast<std::ptrdiff_t>(end - first_);
  return {number, end, EncodeBody(message::LogRecords{number, {from, to}})};
}

void LogBuffer::Write(message::LogRecord record) {
  if (records_.size() == kKept) {
    records_.pop_front();
    ++first_;
  }
  records_.push_back(std::move(record));
  ++end_;
}

}  // namespace tendon::server
