#pragma once

#include <tendon/base/path.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/client/process_links.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/payload/schema.h>
#include <tendon/process/history/history_messages.h>
#include <tendon/process/membership_messages.h>
#include <tendon/process/version_messages.h>
#include <tendon/process/viewer_messages.h>

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace tendon::client {

/// Sends requests to processes. Calls commands with arguments and replies in JSON, which it
/// converts with the schemas of the processes. Calls each handler once, unless the client closes.
/// Thread-safe.
class ProcessRequests final : public std::enable_shared_from_this<ProcessRequests> {
 public:
  template <typename T>
  using Handler = std::function<void(Result<T>)>;

  /// `timer` provides the timeouts.
  ProcessRequests(std::shared_ptr<ProcessLinks> links, std::shared_ptr<Worker> timer,
                  std::chrono::milliseconds timeout);

  void Call(const Path& path, const MemberDescription& command, const std::string& argument,
            Handler<std::string> handler);
  void GetVersion(const std::string& process, Handler<message::ProgramVersion> handler);
  void GetSchema(const std::string& process, Fingerprint fingerprint, Handler<Schema> handler);
  void GetCounts(const InterfaceName& required, Handler<ConnectionCounts> handler);
  void GetProviderCounts(const message::ConnectionEnds& ends, Handler<ConnectionCounts> handler);
  void GetFill(const std::string& process, const std::string& component,
               Handler<MailboxFill> handler);
  void GetProcessHistory(const std::string& process, Handler<message::ProcessHistoryState> handler);
  void ReadLog(const std::string& process, const message::ReadLog& wanted,
               Handler<message::ReadLogReply> handler);
  /// Fetches schemas for FindSchema() from processes that know them. Waits at most 500 ms for each
  /// process.
  void Learn(const std::map<std::string, message::GetSchemas>& types, Handler<void> handler);

 private:
  struct Order;

  template <Payload ReplyBody, Message T>
  void AskProcess(const std::string& process, MessageType type, const T& question,
                  Handler<ReplyBody> handler);
  void FetchSchemas(const std::string& process, std::vector<Fingerprint> fingerprints,
                    Handler<void> handler);
  Result<void> Keep(const std::string& process, const std::vector<Fingerprint>& fingerprints,
                    const message::Schemas& schemas);
  [[nodiscard]] std::optional<Schema> Find(Fingerprint fingerprint) const;
  void Send(const std::shared_ptr<const Order>& order);
  void AskForRefusal(const std::shared_ptr<const Order>& order, const Error& why);
  [[nodiscard]] Result<std::string> Read(const Order& order,
                                         const message::CallMemberReply& called) const;

  const std::shared_ptr<ProcessLinks> links_;
  const std::shared_ptr<Worker> timer_;
  const std::chrono::milliseconds timeout_;
  mutable std::mutex mutex_;
  std::map<Fingerprint, Schema> schemas_;
};

}  // namespace tendon::client
