#pragma once

#include <tendon/base/backoff.h>
#include <tendon/base/clock.h>
#include <tendon/process/connections/peer_link.h>
#include <tendon/process/process_description.h>

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tendon {

/// Keeps a list of the other processes, and the links to the processes that this process needs.
/// Used only on the worker.
class PeerLinks {
 public:
  PeerLinks(ProcessContext& context, PeerListener& listener)
      : context_(context), listener_(listener) {}

  /// Sets the list of present processes from a report of the GCM. Closes no links, because the
  /// report may be outdated.
  void Update(const std::vector<ProcessDescription>& processes);
  /// Adds or updates one process.
  void Learn(const std::string& process, const std::string& address, std::uint64_t instance);

  [[nodiscard]] std::vector<std::string> names() const;
  /// The present instance of a process; empty if the process is absent.
  [[nodiscard]] std::optional<std::uint64_t> InstanceOf(const std::string& process) const;

  using Done = PeerLink::Opened;

  /// Calls `done` with the link to the process. If the link is already open, calls it before
  /// returning. Links to processes that did not answer the last attempt are opened one at a time.
  void LinkTo(const std::string& process, Done done);
  /// Closes links to outdated instances. Also closes links to processes that the GCM has lost and
  /// that do not answer this process either.
  void CloseOutdated();
  void CloseAll();

 private:
  struct Endpoint {
    std::string address;
    std::uint64_t instance = 0;

    bool operator==(const Endpoint&) const = default;
  };

  /// A process that accepts connections but does not answer. It is not tried again for a while,
  /// because an attempt delays other attempts.
  struct UnresponsivePeer {
    Endpoint endpoint;
    Error error;
    // The pauses are at most as long as in RemoteConnections.
    Backoff backoff{std::chrono::milliseconds(500), std::chrono::milliseconds(1500)};
    SteadyTime until{};
  };

  void Open(const std::string& process);
  void Finish(const std::string& process, const Endpoint& tried,
              const Result<std::shared_ptr<PeerLink>>& opened);
  void RecordOutcome(const std::string& process, const Endpoint& tried,
                     const Result<std::shared_ptr<PeerLink>>& opened);

  ProcessContext& context_;
  PeerListener& listener_;
  std::map<std::string, Endpoint> endpoints_;
  std::map<std::string, std::shared_ptr<PeerLink>> links_;
  std::map<std::string, std::vector<Done>> openings_;  // the callbacks that wait for each process
  std::map<std::string, UnresponsivePeer> unresponsive_;
  // To be opened one at a time; the first one is being opened.
  std::deque<std::string> unresponsive_queue_;
};

}  // namespace tendon
