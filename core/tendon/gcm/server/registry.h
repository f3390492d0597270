#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/gcm/server/connection_restorer.h>
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

/// When a member that does not renew its lease becomes suspect and lost, and when a tombstone is
/// removed.
struct Leases {
  std::chrono::milliseconds suspect_after{750};
  std::chrono::milliseconds lost_after{1500};
  std::chrono::hours tombstone_for{24};
};

/// The token of a membership.
using Session = std::uint64_t;

/// The members with their names, and the catalogue that follows from their reports. A name has at
/// most one member. Its session, a random number, proves the membership. Only decides: the caller
/// sends and closes. Not thread-safe.
class Registry {
 public:
  Registry(Leases leases, const Clock& clock) : leases_(leases), clock_(clock) {}

  struct Admission {
    Session session = 0;
    std::shared_ptr<Channel> replaced;  ///< of the process's last membership; may be null
  };
  /// Errors: kInvalid; kExists, with the holder of the name. `held` is the session of an earlier
  /// membership of the same process, which the new one continues.
  Result<Admission> Join(message::Join join, Session held, std::shared_ptr<Channel> channel);

  /// Skips invalid changes; the error names the first.
  Result<void> Report(Session session, message::Report report);
  /// kDenied if the membership is over.
  Result<void> Renew(Session session);
  /// Changes nothing in the catalogue. kDenied if the membership is over.
  Result<void> TakeHealth(Session session, const message::Health& health);
  /// The process becomes a tombstone. Does nothing if the membership is over.
  void End(Session session, ProcessState state, const std::string& reason);
  /// The program of a process is being started; with `pid`, it was started. Until it joins, the
  /// catalogue shows it as starting, with its former components. Does nothing if there is a member
  /// of that name.
  void Expect(const std::string& process, std::int64_t pid);
  /// It will not join: restores the former entry of the catalogue, if any. Does nothing if the
  /// process is not expected.
  void GiveUp(const std::string& process);
  /// Adds to the reason why a process is gone; returns false if it has no tombstone.
  bool Explain(const std::string& process, const std::string& reason);
  /// Removes a tombstone. kNotFound; kFailed for a present process.
  Result<void> Forget(const std::string& process);

  /// Checks the leases; call it often. Returns the channels of lost members, which are to be
  /// closed.
  std::vector<std::shared_ptr<Channel>> Tick();

  [[nodiscard]] const Catalogue& catalogue() const { return catalogue_; }
  /// A member's entry in the catalogue; null if the membership is over.
  [[nodiscard]] const ProcessDescription* FindMember(Session session) const;
  /// The channel of a member, else null.
  [[nodiscard]] std::shared_ptr<Channel> ChannelOf(const std::string& process) const;
  [[nodiscard]] std::vector<std::shared_ptr<Channel>> channels() const;
  [[nodiscard]] message::PeerList peers() const;
  [[nodiscard]] message::SystemHealth health() const;

  /// The changes since the last call.
  [[nodiscard]] std::vector<CatalogueChange> TakeChanges() { return std::exchange(changes_, {}); }
  /// The connections to make again now. Report each outcome to SettleHandBack().
  [[nodiscard]] std::vector<message::Wire> TakeDueHandBacks();
  ConnectionRestorer::Verdict SettleHandBack(const message::Wire& wire,
                                             const Result<void>& outcome);

 private:
  struct Member {
    std::string name;
    std::uint64_t instance = 0;
    Session session = 0;
    std::shared_ptr<Channel> channel;
    std::string link;  // address of its end of the channel
    SteadyTime renewed;
    std::int64_t joined = 0;  // ns since 1970
    std::optional<message::Health> health;
    SteadyTime told;    // when it reported its health
    double cpu = -1.0;  // as in ProcessHealth
  };

  Member* Find(Session session);
  [[nodiscard]] const Member* FindByName(const std::string& name) const;
  [[nodiscard]] Error NameInUse(const Member& member) const;
  void Enter(const message::Join& join, const std::string& link, std::int64_t now);
  void Apply(CatalogueChange change);
  void SetState(const std::string& process, ProcessState state, const std::string& reason);
  void SuspendConnections(const std::string& process);
  void Forgive(SteadyTime now);
  void ClearTombstones(SteadyTime now);
  void Remove(const std::string& process);

  const Leases leases_;
  const Clock& clock_;
  Catalogue catalogue_;
  DescriptionPool pool_;
  std::map<Session, Member> members_;
  std::map<std::string, SteadyTime> tombstones_;  // since when
  /// Starting processes, with their former entries.
  std::map<std::string, std::optional<ProcessDescription>> expected_;
  ConnectionRestorer hand_backs_;
  bool look_for_hand_backs_ = false;
  std::vector<CatalogueChange> changes_;
  SteadyTime last_tick_ = clock_.Now();
};

}  // namespace tendon::server
