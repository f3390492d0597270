#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/gcm/members/connection_restorer.h>
#include <tendon/process/description_pool.h>
#include <tendon/process/membership_messages.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tendon {
class Channel;
}

namespace tendon::server {

/// Time limits: when a member that does not renew its lease becomes suspect and then lost, and when
/// a process that is gone is removed.
struct Leases {
  std::chrono::milliseconds suspect_after{750};
  std::chrono::milliseconds lost_after{1500};
  std::chrono::hours tombstone_for{24};
};

/// A random number that proves a membership; 0: none.
using SessionToken = std::uint64_t;

/// The members, and the catalogue that results from their reports. A name has at most one member.
/// Makes only decisions: the caller sends messages and closes channels. Not thread-safe.
class Registry {
 public:
  Registry(Leases leases, const Clock& clock) : leases_(leases), clock_(clock) {}

  struct Admission {
    SessionToken session = 0;
    std::shared_ptr<Channel> replaced;  ///< channel of the process's last membership; may be null
  };
  /// Errors: kInvalid; kExists, with the holder of the name. `held` is the session of an earlier
  /// membership of the same process, which the new one continues.
  Result<Admission> Join(message::Join join, SessionToken held, std::shared_ptr<Channel> channel);

  /// Applies a report. Skips invalid changes; the error names the first one.
  Result<void> Report(SessionToken session, message::Report report);
  /// Renews a lease. kDenied if the membership has ended.
  Result<void> Renew(SessionToken session);
  /// Stores the health of a process, which is not part of the catalogue. kDenied if the membership
  /// has ended.
  Result<void> UpdateHealth(SessionToken session, const message::Health& health);
  /// Ends a membership; the catalogue keeps the process as lost or left. Does nothing if the
  /// membership has already ended.
  void End(SessionToken session, ProcessState state, const std::string& reason);
  /// Called when the program of a process is being started; `pid` is set when it was started. Until
  /// the process joins, the catalogue shows it as starting, with its former components. Does
  /// nothing if there is a member with that name.
  void Expect(const std::string& process, std::int64_t pid);
  /// Called when an expected process will not join: restores its former entry in the catalogue, if
  /// any. Does nothing if the process is not expected.
  void GiveUp(const std::string& process);
  /// Adds a text to the reason why a process is gone; returns false if the catalogue has no process
  /// that is gone with this name.
  bool SetReason(const std::string& process, const std::string& reason);
  /// Removes a process that is lost or has left. kNotFound for an unknown process; kFailed for a
  /// present one.
  Result<void> Forget(const std::string& process);

  /// Checks the leases; call it often. Returns the channels of lost members, which the caller must
  /// close.
  std::vector<std::shared_ptr<Channel>> Tick();

  [[nodiscard]] const Catalogue& catalogue() const { return catalogue_; }
  /// A member's entry in the catalogue; null if the membership has ended.
  [[nodiscard]] const ProcessDescription* FindMember(SessionToken session) const;
  /// The channel of a member; null if there is no such member.
  [[nodiscard]] std::shared_ptr<Channel> ChannelOf(const std::string& process) const;
  [[nodiscard]] std::vector<std::shared_ptr<Channel>> channels() const;
  [[nodiscard]] message::PeerList peers() const;
  [[nodiscard]] message::SystemHealth health() const;

  /// The changes since the last call.
  [[nodiscard]] std::vector<CatalogueChange> TakeChanges() { return std::exchange(changes_, {}); }
  /// The connections to make again now. Call OnRestored() with each outcome.
  [[nodiscard]] std::vector<message::Wire> TakeDueConnections();
  ConnectionRestorer::Verdict OnRestored(const message::Wire& wire, const Result<void>& outcome);

 private:
  struct Member {
    std::string name;
    std::uint64_t instance = 0;
    SessionToken session = 0;
    std::shared_ptr<Channel> channel;
    std::string link;  // address of its end of the channel
    SteadyTime renewed;
    std::int64_t joined = 0;  // ns since 1970
    std::optional<message::Health> health;
    SteadyTime reported;  // time of its last health report
    double cpu = -1.0;    // as in ProcessHealth
  };

  Member* Find(SessionToken session);
  [[nodiscard]] const Member* FindByName(const std::string& name) const;
  [[nodiscard]] Error NameInUse(const Member& member) const;
  void Enter(const message::Join& join, const std::string& link, std::int64_t now);
  void Apply(CatalogueChange change);
  void SetState(const std::string& process, ProcessState state, const std::string& reason);
  void SuspendConnections(const std::string& process);
  void ExtendLeases(SteadyTime now);
  void ClearTombstones(SteadyTime now);
  void Remove(const std::string& process);

  const Leases leases_;
  const Clock& clock_;
  Catalogue catalogue_;
  DescriptionPool pool_;
  std::map<SessionToken, Member> members_;
  std::map<std::string, SteadyTime> tombstones_;  // processes that are gone, and since when
  /// Processes that are being started, with their former entries.
  std::map<std::string, std::optional<ProcessDescription>> expected_;
  ConnectionRestorer restorer_;
  bool are_connections_due_ = false;
  std::vector<CatalogueChange> changes_;
  SteadyTime last_tick_ = clock_.Now();
};

}  // namespace tendon::server
