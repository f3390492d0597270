#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/viewer_messages.h>
#include <tests/core/gcm/samples.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace tendon::test {

/// A process as a GCM and its viewers see it: only channels. It executes its orders, unless the
/// test sets another behaviour.
class FakeProcess {
 public:
  /// Its behaviour when it receives an order to connect or to disconnect.
  enum class Manners {
    kObey,
    kRefuse,
    kRefuseConnects,
    kRefuseTheNextConnect,
    kMissTheNextProvider,  ///< reports that it could not reach the provider: the connection is
                           ///< pending
    kSayNothing,
    kObeyAndDie,        ///< executes the order, and breaks its link instead of answering
    kDelay,             ///< keeps orders until it obeys again
    kDelayFromConnect,  ///< keeps orders from the next order to connect on
  };

  /// Creates a new instance of the process `name`. It listens for viewers.
  FakeProcess(std::shared_ptr<Middleware> middleware, const std::string& name);
  FakeProcess(const FakeProcess&) = delete;
  FakeProcess& operator=(const FakeProcess&) = delete;
  /// Breaks the link, as if the process were killed.
  ~FakeProcess();

  /// Adds a component. After Join(), the process reports it.
  void Add(const ComponentDescription& component);
  void Remove(const std::string& component);
  /// Sets the address that the process announces to viewers and other processes, instead of the
  /// address at which it listens.
  void Advertise(const std::string& address);
  /// Adds a type that only this process knows. The process describes it on request.
  void Know(const Schema& schema);

  Result<message::JoinReply> Join(const std::string& gcm);
  Result<None> Renew();
  Result<message::GcmClock> ReportHealth(const message::Health& health);
  Result<None> Leave();
  /// Breaks the link. The process keeps its session for a new link.
  void BreakLink();
  void Report(const std::vector<CatalogueChange>& changes);
  Status SendLog(const message::LogRecords& records);

  /// Sets by how much the steady clock that it reports to the listeners of its events is ahead.
  void SetClockAhead(std::chrono::nanoseconds ahead);
  /// Sends its first event to the newest listener, with the time `when`.
  void Raise(double value, SteadyTime when);

  void set_manners(Manners manners);
  [[nodiscard]] const ProcessDescription& description() const;
  [[nodiscard]] std::vector<message::ConnectionPlan> orders() const;
  [[nodiscard]] message::PeerList peers() const;
  [[nodiscard]] std::size_t connection_count() const;
  [[nodiscard]] bool is_linked() const;
  /// Returns the last argument of MoveTo; empty if there was none.
  [[nodiscard]] std::optional<Joints> goal() const;
  [[nodiscard]] int schema_requests() const;
  [[nodiscard]] int clock_requests() const;
  /// Returns the number of requests for past events. It never answers them.
  [[nodiscard]] std::size_t waiting_readers() const;

 private:
  class State;
  const std::shared_ptr<Middleware> middleware_;
  const std::shared_ptr<State> state_;
  std::unique_ptr<Listener> listener_;
};

}  // namespace tendon::test
