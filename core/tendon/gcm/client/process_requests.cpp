#include <tendon/gcm/client/process_requests.h>

#include <tendon/gcm/client/json_field.h>
#include <tendon/gcm/lookup.h>
#include <tendon/payload/json.h>
#include <tendon/process/ask.h>
#include <tendon/process/schema_exchange.h>

#include <algorithm>
#include <utility>

namespace tendon::client {
namespace {

bool HasResult(CommandKind kind) {
  return kind != CommandKind::kVoid && kind != CommandKind::kWrite;
}

Error CallError(const std::string& command, Status status) {
  const std::string words = command + ": " + std::string(ToString(status));
  switch (status.code()) {
    case Status::kNotActive:
      return {ErrorCode::kFailed, words + "; start the component of this command first"};
    case Status::kQueueFull:
      return {ErrorCode::kFailed,
              words +
                  "; the component executes its calls too slowly: try again; if the call fails "
                  "each time, check that Run() of the component calls ProcessQueuedCommands()"};
    case Status::kTimeout:
    case Status::kOutcomeUnknown:
      return {ErrorCode::kTimeout, words};
    case Status::kDenied:
      return {ErrorCode::kDenied, words};
    case Status::kInvalid:
      return {ErrorCode::kInvalid, words};
    default:
      return {ErrorCode::kFailed, words};
  }
}

/// Checks that an argument is given if and only if the command takes one.
Result<void> CheckArgument(const std::string& command, const MemberDescription& description,
                           const std::string& argument) {
  const bool is_given = !argument.empty() && argument != "null";
  if (is_given == TakesArgument(description.signature)) return {};
  if (is_given) return Error{ErrorCode::kInvalid, command + " takes no argument"};
  return Error{ErrorCode::kInvalid, command + " needs an argument of " + description.in_type +
                                        " as JSON; gcm show " + command + " prints an example"};
}

}  // namespace

struct ProcessRequests::Order {
  Path path;
  std::string command;  // for errors: "robot/arm/Control.MoveTo"
  Signature signature;
  std::string argument;
  Handler<std::string> handler;
};

ProcessRequests::ProcessRequests(std::shared_ptr<ProcessLinks> links, std::shared_ptr<Worker> timer,
                                 std::chrono::milliseconds timeout)
    : links_(std::move(links)), timer_(std::move(timer)), timeout_(timeout) {}

void ProcessRequests::Call(const Path& path, const MemberDescription& command,
                           const std::string& argument, Handler<std::string> handler) {
  const std::string name = ToString(path.interface_name()) + "." + path.member;
  if (auto checked = CheckArgument(name, command, argument); !checked) {
    return handler(checked.error());
  }
  const auto order = std::make_shared<const Order>(
      Order{path, name, command.signature, argument, std::move(handler)});
  std::vector<Fingerprint> needed;
  if (TakesArgument(order->signature)) needed.push_back(order->signature.in);
  if (HasResult(order->signature.kind)) needed.push_back(order->signature.out);
  FetchSchemas(path.process, needed,
               [self = shared_from_this(), order](const Result<void>& fetched) {
                 if (fetched) return self->Send(order);
                 if (fetched.error().code != ErrorCode::kNotFound) {
                   return order->handler(fetched.error());
                 }
                 self->AskForRefusal(order, fetched.error());
               });
}

/// Calls the command without an argument, because the reply says why the process cannot execute
/// the command. A process that does not know the types of its own commands, such as a replay,
/// cannot execute them.
void ProcessRequests::AskForRefusal(const std::shared_ptr<const Order>& order, const Error& why) {
  const Path& path = order->path;
  const message::CallMember call{path.component, path.interface, path.member, {}, timeout_ * 3 / 4};
  links_->WithChannel(
      path.process, [self = shared_from_this(), order, why, call](const auto& channel) {
        if (!channel) return order->handler(channel.error());
        Ask<message::CallMemberReply>(
            *self->timer_, *channel, message::kCallMember, call, self->timeout_,
            [order, why](const auto& called) { order->handler(called ? why : called.error()); });
      });
}

void ProcessRequests::GetSchema(const std::string& process, Fingerprint fingerprint,
                                Handler<Schema> handler) {
  FetchSchemas(process, {fingerprint},
               [self = shared_from_this(), fingerprint,
                handler = std::move(handler)](const Result<void>& fetched) {
                 if (!fetched) return handler(fetched.error());
                 handler(*self->Find(fingerprint));
               });
}

void ProcessRequests::GetVersion(const std::string& process,
                                 Handler<message::ProgramVersion> handler) {
  AskProcess(process, message::kGetProgram, None{}, std::move(handler));
}

void ProcessRequests::GetCounts(const InterfaceName& required, Handler<ConnectionCounts> handler) {
  AskProcess(required.process, message::kGetCounts, message::GetCounts{required},
             std::move(handler));
}

void ProcessRequests::GetProviderCounts(const message::ConnectionEnds& ends,
                                        Handler<ConnectionCounts> handler) {
  AskProcess(ends.provided.process, message::kGetCounts, message::GetCounts{ends.required},
             std::move(handler));
}

void ProcessRequests::GetFill(const std::string& process, const std::string& component,
                              Handler<MailboxFill> handler) {
  AskProcess(process, message::kGetFill, message::GetFill{component}, std::move(handler));
}

void ProcessRequests::GetProcessHistory(const std::string& process,
                                        Handler<message::ProcessHistoryState> handler) {
  AskProcess(process, message::kGetProcessHistory, None{}, std::move(handler));
}

void ProcessRequests::ReadLog(const std::string& process, const message::ReadLog& wanted,
                              Handler<message::ReadLogReply> handler) {
  AskProcess(process, message::kReadLog, wanted, std::move(handler));
}

template <Payload ReplyBody, Message T>
void ProcessRequests::AskProcess(const std::string& process, MessageType type, const T& question,
                                 Handler<ReplyBody> handler) {
  links_->WithChannel(process, [self = shared_from_this(), type, question,
                                handler = std::move(handler)](const auto& channel) {
    if (!channel) return handler(channel.error());
    Ask<ReplyBody>(*self->timer_, *channel, type, question, self->timeout_, handler);
  });
}

void ProcessRequests::Learn(const std::map<std::string, message::GetSchemas>& types,
                            Handler<void> handler) {
  const auto timeout = std::min(timeout_, std::chrono::milliseconds(500));
  // The deleter calls the handler when the last copy is destroyed, which is when all processes have
  // answered.
  const std::shared_ptr<void> all(nullptr, [handler](void* /*nothing*/) { handler({}); });
  for (const auto& [process, wanted] : types) {
    links_->WithChannel(
        process, [self = shared_from_this(), wanted = wanted, timeout, all](const auto& channel) {
          if (!channel) return;
          LearnSchemas(*self->timer_, *channel, wanted, timeout, [all] { static_cast<void>(all); });
        });
  }
}

/// Asks the process for the schemas that are not known yet. Calls the handler when they are known.
void ProcessRequests::FetchSchemas(const std::string& process,
                                   std::vector<Fingerprint> fingerprints, Handler<void> handler) {
  std::erase_if(fingerprints,
                [this](const Fingerprint& fingerprint) { return Find(fingerprint).has_value(); });
  if (fingerprints.empty()) return handler({});
  links_->WithChannel(process, [self = shared_from_this(), process, fingerprints,
                                handler = std::move(handler)](const auto& channel) {
    if (!channel) return handler(channel.error());
    Ask<message::Schemas>(*self->timer_, *channel, message::kGetSchemas,
                          message::GetSchemas{fingerprints}, self->timeout_,
                          [self, process, fingerprints, handler](const auto& schemas) {
                            if (!schemas) return handler(schemas.error());
                            handler(self->Keep(process, fingerprints, *schemas));
                          });
  });
}

Result<void> ProcessRequests::Keep(const std::string& process,
                                   const std::vector<Fingerprint>& fingerprints,
                                   const message::Schemas& schemas) {
  for (std::size_t i = 0; i < fingerprints.size(); ++i) {
    const std::string wanted = ToString(fingerprints[i]);
    if (i >= schemas.texts.size() || schemas.texts[i].empty()) {
      return Error{ErrorCode::kNotFound,
                   "process '" + process + "' has no payload type with the fingerprint " + wanted};
    }
    const auto schema = Schema::Parse(schemas.texts[i]);
    if (!schema) return schema.error();
    if (schema->fingerprint() != fingerprints[i]) {
      return Error{ErrorCode::kInvalid,
                   "process '" + process +
                       "' sent a schema that does not have the requested fingerprint " + wanted};
    }
    const std::scoped_lock lock(mutex_);
    schemas_.insert_or_assign(fingerprints[i], *schema);
  }
  return {};
}

std::optional<Schema> ProcessRequests::Find(Fingerprint fingerprint) const {
  const std::scoped_lock lock(mutex_);
  const auto found = schemas_.find(fingerprint);
  return found == schemas_.end() ? std::nullopt : std::optional(found->second);
}

/// Converts the argument and sends the call. Called when all schemas are known.
void ProcessRequests::Send(const std::shared_ptr<const Order>& order) {
  const Path& path = order->path;
  message::CallMember call{path.component, path.interface, path.member, {}, timeout_ * 3 / 4};
  if (TakesArgument(order->signature)) {
    auto argument = FromJson(*Find(order->signature.in), order->argument);
    if (!argument) {
      return order->handler(
          Error{ErrorCode::kInvalid, order->command + ": " + argument.error().message});
    }
    call.argument = *std::move(argument);
  }
  links_->WithChannel(path.process, [self = shared_from_this(), order,
                                     call = std::move(call)](const auto& channel) {
    if (!channel) return order->handler(channel.error());
    Ask<message::CallMemberReply>(*self->timer_, *channel, message::kCallMember, call,
                                  self->timeout_, [self, order](const auto& called) {
                                    if (!called) return order->handler(called.error());
                                    order->handler(self->Read(*order, *called));
                                  });
  });
}

Result<std::string> ProcessRequests::Read(const Order& order,
                                          const message::CallMemberReply& called) const {
  constexpr std::uint8_t kLast = Status::kFailed;
  const Status status(called.status <= kLast ? static_cast<Status::Code>(called.status)
                                             : Status::kFailed);
  if (!status) return CallError(order.command, status);
  if (!HasResult(order.signature.kind)) return std::string();
  auto json = ToJson(*Find(order.signature.out), called.result);
  if (!json) return Error{ErrorCode::kInvalid, order.command + ": " + json.error().message};
  return JsonField(*json, order.path.field);
}

}  // namespace tendon::client
