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

/// A process as a GCM and its viewers see it, made only of channels. It executes its orders, unless
/// the test sets another behaviour.
class FakeProcess {
 public:
  /// Its behaviour when it receives an order to connect or disconnect.
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

  /// A new instance of the process `name`. It listens for viewers.
  FakeProcess(std::shared_ptr<Middleware> middleware, const std::string& name);
  FakeProcess(const FakeProcess&) = delete;
  FakeProcess& operator=(const FakeProcess&) = delete;
  /// Breaks the link, as if the process were killed.
  ~FakeProcess();

  /// Adds a component. After Join(), the process reports it.
  void Add(const ComponentDescription& component);
  void Remove(const std::string& component);
  /// The address that it announces to viewers and other processes, instead of the one at which it
  /// listens.
  void Advertise(const std::string& address);
  /// A type that only this process knows, and that it describes on request.
  void Know(const Schema& schema);

  Result<message::JoinReply> Join(const std::string& gcm);
  Result<None> Renew();
  Result<message::GcmClock> ReportHealth(const message::Health& health);
  Result<None> Leave();
  /// Breaks the link, but keeps the session for a new one.
  void BreakLink();
  void Report(const std::vector<CatalogueChange>& changes);
  Status SendLog(const message::LogRecords& records);

  /// The time of its steady clock that it reports to listeners to its events.
  void SetClockAhead(std::chrono::nanoseconds ahead);
  /// Sends its first event to the newest listener, with the time `when`.
  void Raise(double value, SteadyTime when);

  void set_manners(Manners manners);
  [[nodiscard]] const ProcessDescription& description() const;
  [[nodiscard]] std::vector<message::ConnectionPlan> orders() const;
  [[nodiscard]] message::PeerList peers() const;
  [[nodiscard]] std::size_t connection_count() const;
  [[nodiscard]] bool is_linked() const;
  /// The last argument of MoveTo.
  [[nodiscard]] std::optional<Joints> goal() const;
  [[nodiscard]] int schema_requests() const;
  [[nodiscard]] int clock_requests() const;

 private:
  class State;
  const std::shared_ptr<Middleware> middleware_;
  const std::shared_ptr<State> state_;
  std::unique_ptr<Listener> listener_;
};

}  // namespace tendon::test
