#include <tendon/base/log.h>
#include <tendon/base/os/process.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/server/sanitize.h>
#include <tendon/gcm/server/server.h>
#include <tendon/middleware/hello.h>
#include <tendon/process/ask.h>

#include <utility>

/// The part of the server that handles the logs of other processes and its own.
namespace tendon::server {
namespace {

/// True if this program is the process, so that its records are already in the buffer: a window
/// that hosts a GCM is also a process.
bool IsOwn(const ProcessDescription& process) {
  return process.name == kGcmName && process.pid == os::ProcessId() &&
         process.host == os::HostName();
}

}  // namespace

/// Called in an action of the outbox; also retries watchers whose links were full.
void Server::WriteOwnLog() {
  auto records = own_log_.Take(LogQueue::kCapacity, SteadyClock().Now());
  for (message::LogRecord& record : records) log_book_.AddOwn(std::move(record));
  log_book_.PumpAll();
}

void Server::WatchLog(const Request& request) {
  const auto watch = DecodeBody<message::WatchLog>(request.body);
  if (!watch) return request.responder->Refuse(watch.error());
  const bool goes_on = watch->gcm_instance == options_.instance;
  Locked([&] {
    outbox_.Add([this, channel = request.channel, responder = request.responder,
                 after = goes_on ? watch->after : 0] {
      if (!channel->is_open()) return;
      message::WatchLogReply watched = log_book_.Watch(channel, after);
      watched.gcm_instance = options_.instance;
      responder->Answer(Result(watched));
      log_book_.Pump();
    });
  });
}

void Server::SetLogLevel(const Request& request) {
  const auto order = DecodeBody<message::SetLogLevel>(request.body);
  if (!order) return request.responder->Refuse(order.error());
  Locked([&] {
    const auto entry = LookUpProcess(registry_.catalogue(), order->process);
    if (!entry) return Answer<None>(request, entry.error());
    const auto present = RequirePresent((*entry)->process);
    if (!present) return Answer(request, present);
    outbox_.Add([this, channel = registry_.ChannelOf(order->process), order = *order,
                 who = NameOf(*request.channel), responder = request.responder] {
      Ask<None>(worker_, channel, message::kSetLogLevel, order, options_.order_timeout,
                [order, who, responder](const auto& done) {
                  if (done) {
                    Log(LogLevel::kInfo, "gcm",
                        who + " has set the log level of process '" + order.process + "' to " +
                            std::string(ToString(order.level)));
                  }
                  responder->Answer(done);
                });
    });
  });
}

void Server::TakeLog(const Session& session, std::span<const std::byte> body) {
  if (body.size() > message::kLargestLogBatch) return;
  auto batch = DecodeBody<message::LogRecords>(body);
  if (!batch) return not_understood_.Add("records were not understood: " + batch.error().message);
  Sanitize(*batch);
  Locked([&] {
    const ProcessDescription* process = registry_.FindMember(session);
    if (process == nullptr || IsOwn(*process)) return;
    outbox_.Add([this, name = process->name, instance = process->instance,
                 records = *std::move(batch)]() mutable {
      log_book_.Add(name, instance, std::move(records));
      log_book_.Pump();
    });
  });
}

}  // namespace tendon::server
