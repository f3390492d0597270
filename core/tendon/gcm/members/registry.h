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

/// Time limits: when a member without renewals becomes suspect, when it becomes lost, and when an
/// absent process is removed from the catalogue.
struct Leases {
  std::chrono::milliseconds suspect_after{750};
  std::chrono::milliseconds lost_after{1500};
  std::chrono::hours tombstone_for{24};
};

/// A random number that identifies a membership, and proves that a process has it; 0: none.
using SessionToken = std::uint64_t;

/// The processes that have joined, called members, and the catalogue that results from their
/// reports. No two members have the same name. The registry only makes decisions. The caller sends
/// messages and closes channels. Not thread-safe.
class Registry {
 public:
  Registry(Leases leases, const Clock& clock) : leases_(leases), clock_(clock) {}

  struct Admission {
    SessionToken session = 0;
    /// The channel of the membership that the new membership continues; may be null.
    std::shared_ptr<Channel> replaced;
  };
  /// Adds a member. If `held` is the session of the present membership of the same process
  /// instance, the new membership continues this membership. Fails with kInvalid for invalid data,
  /// and with kExists if another process has the name; the error describes that process.
  Result<Admission> Join(message::Join join, SessionToken held, std::shared_ptr<Channel> channel);

  /// Applies the changes in a report. Skips invalid changes; the error describes the first of them.
  Result<void> Report(SessionToken session, message::Report report);
  /// Renews the lease of a member. Fails with kDenied if the membership has ended.
  Result<void> Renew(SessionToken session);
  /// Stores the health of a process, which is not part of the catalogue. Fails with kDenied if the
  /// membership has ended.
  Result<void> UpdateHealth(SessionToken session, const message::Health& health);
  /// Ends a membership. The process stays in the catalogue with `state`, which is lost or left.
  /// Does nothing if the membership has already ended.
  void End(SessionToken session, ProcessState state, const std::string& reason);
  /// Called when the GCM is about to start the program of a process (`pid` is 0), and again when
  /// the program is started. The catalogue shows the process as starting, with its former
  /// components, until it joins. Does nothing if there is a member with this name.
  void Expect(const std::string& process, std::int64_t pid);
  /// Called when an expected process will not join. Restores the former entry of the process in the
  /// catalogue. Removes the present entry if there was no former entry. Does nothing if the process
  /// is not expected.
  void GiveUp(const std::string& process);
  /// Sets the reason why a process is absent. Returns false if the catalogue has no process with
  /// this name, or if the process is present.
  bool SetReason(const std::string& process, const std::string& reason);
  /// Removes a process that is lost or has left from the catalogue. Fails with kNotFound for an
  /// unknown process, and with kFailed for a process that is present or starting.
  Result<void> Forget(const std::string& process);

  /// Checks the leases; must be called regularly. Returns the channels of members that have just
  /// been lost. The caller must close these channels.
  std::vector<std::shared_ptr<Channel>> Tick();

  [[nodiscard]] const Catalogue& catalogue() const { return catalogue_; }
  /// Returns the entry of a member in the catalogue; null if the membership has ended.
  [[nodiscard]] const ProcessDescription* FindMember(SessionToken session) const;
  /// Returns the channel of a member; null if there is no such member.
  [[nodiscard]] std::shared_ptr<Channel> ChannelOf(const std::string& process) const;
  [[nodiscard]] std::vector<std::shared_ptr<Channel>> channels() const;
  [[nodiscard]] message::PeerList peers() const;
  [[nodiscard]] message::SystemHealth health() const;

  /// Returns the changes of the catalogue since the last call.
  [[nodiscard]] std::vector<CatalogueChange> TakeChanges() { return std::exchange(changes_, {}); }
  /// Returns the connections that should be restored now. The caller must call OnRestored() with
  /// the outcome for each of them.
  [[nodiscard]] std::vector<message::ConnectionEnds> TakeDueConnections();
  ConnectionRestorer::Verdict OnRestored(const message::ConnectionEnds& ends,
                                         const Result<void>& outcome);

 private:
  struct Member {
    std::string name;
    std::uint64_t instance = 0;
    SessionToken session = 0;
    std::shared_ptr<Channel> channel;
    std::string link;  // address of the member's end of the channel
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
  // The time when each absent process was lost, by name.
  std::map<std::string, SteadyTime> tombstones_;
  /// Processes that are being started, with their former entries in the catalogue.
  std::map<std::string, std::optional<ProcessDescription>> expected_;
  ConnectionRestorer restorer_;
  bool are_connections_due_ = false;
  std::vector<CatalogueChange> changes_;
  SteadyTime last_tick_ = clock_.Now();
};

}  // namespace tendon::server
