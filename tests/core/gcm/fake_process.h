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

/// A process as a GCM and its viewers see it, made only of channels. It executes its orders, or
/// does what the test sets instead.
class FakeProcess {
 public:
  /// What it does with orders to connect and disconnect.
  enum class Manners {
    kObey,
    kRefuse,
    kRefuseConnects,
    kRefuseTheNextConnect,
    kMissTheNextProvider,  ///< it is not reached: the connection is pending
    kSayNothing,
    kObeyAndDie,        ///< its link breaks instead of its answer
    kDelay,             ///< until it obeys again
    kDelayFromConnect,  ///< the same, beginning with the next one
  };

  /// A new instance of the process `name`. It listens for viewers.
  FakeProcess(std::shared_ptr<Middleware> middleware, const std::string& name);
  FakeProcess(const FakeProcess&) = delete;
  FakeProcess& operator=(const FakeProcess&) = delete;
  /// Like a kill: its link breaks.
  ~FakeProcess();

  /// Before Join(): what it has. Afterwards it reports.
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
  /// Breaks the link, but knows its session.
  void BreakLink();
  void Report(const std::vector<CatalogueChange>& changes);
  Status SendLog(const message::LogRecords& records);

  /// The time of its steady clock that it reports to listeners to its events.
  void SetClockAhead(std::chrono::nanoseconds ahead);
  /// Sends the first event to the last listener, with that time.
  void Raise(double value, SteadyTime when);

  void set_manners(Manners manners);
  [[nodiscard]] const ProcessDescription& description() const;
  [[nodiscard]] std::vector<message::Wiring> orders() const;
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
