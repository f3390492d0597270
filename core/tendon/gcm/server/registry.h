#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/catalog.h>
#include <tendon/gcm/messages.h>
#include <tendon/gcm/server/hand_backs.h>
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

/// When a member that does not renew its lease is suspected and given up, and when a tombstone is
/// cleared away.
struct Leases {
  std::chrono::milliseconds suspect_after{750};
  std::chrono::milliseconds lost_after{1500};
  std::chrono::hours tombstone_for{24};
};

/// A membership that has ended, or the token of one that has begun.
using Session = std::uint64_t;

/// Who is a member under which name, and the catalogue that follows from what members say. A name
/// has at most one member; the membership is proven by its session, a number that nobody can guess.
/// Only decides: sending and closing are left to the caller. Not thread-safe.
class Registry {
 public:
  Registry(Leases leases, const Clock& clock) : leases_(leases), clock_(clock) {}

  struct Admission {
    Session session = 0;
    std::shared_ptr<Channel> replaced;  ///< of the same process' last membership; may be null
  };
  /// Errors: kInvalid; kExists, with who holds the name. `held` is the session that the newcomer
  /// brings along: one of its own may be taken over.
  Result<Admission> Join(message::Join join, Session held, std::shared_ptr<Channel> channel);

  /// Steps that make no sense are left out; the error names the first.
  Result<void> Report(Session session, message::Report report);
  /// kDenied when the membership is over.
  Result<void> Renew(Session session);
  /// Changes nothing in the catalogue. kDenied when the membership is over.
  Result<void> TakeHealth(Session session, const message::Health& health);
  /// The process becomes a tombstone. Nothing happens when the membership is over.
  void End(Session session, ProcessState state, const std::string& reason);
  /// The program of a process is started, or, with its pid, was: until that joins, the catalogue
  /// has it as starting, with what it had before. Nothing happens where there is a member of that
  /// name.
  void Expect(const std::string& process, std::int64_t pid);
  /// It does not come: the catalogue has what it had before, if it had anything. Nothing happens
  /// where the process is not expected.
  void GiveUp(const std::string& process);
  /// Says more of why a process is gone; false where there is no tombstone of it.
  bool Explain(const std::string& process, const std::string& reason);
  /// Removes a tombstone; kNotFound, or kFailed for a process that is there.
  Result<void> Forget(const std::string& process);

  /// Judges the leases; to be called often. The channels of the members that were given up, to be
  /// closed.
  std::vector<std::shared_ptr<Channel>> Tick();

  [[nodiscard]] const Catalog& catalog() const { return catalog_; }
  /// Of a member, as the catalogue has it; null when the membership is over.
  [[nodiscard]] const ProcessDescription* FindMember(Session session) const;
  /// Of a member, else null.
  [[nodiscard]] std::shared_ptr<Channel> ChannelOf(const std::string& process) const;
  [[nodiscard]] std::vector<std::shared_ptr<Channel>> channels() const;
  [[nodiscard]] message::Peers peers() const;
  [[nodiscard]] message::SystemHealth health() const;

  /// What happened since it was last asked.
  [[nodiscard]] std::vector<CatalogChange> TakeChanges() { return std::exchange(changes_, {}); }
  /// Connections to be made again now; SettleHandBack() is then told what became of each.
  [[nodiscard]] std::vector<message::Wire> TakeDueHandBacks();
  HandBacks::Verdict SettleHandBack(const message::Wire& wire, const Result<void>& outcome);

 private:
  struct Member {
    std::string name;
    std::uint64_t instance = 0;
    Session session = 0;
    std::shared_ptr<Channel> channel;
    std::string link;  // where its end of the channel is
    SteadyTime renewed;
    std::int64_t joined = 0;  // ns since 1970
    std::optional<message::Health> health;
    SteadyTime told;    // its health
    double cpu = -1.0;  // as in ProcessHealth
  };

  Member* Find(Session session);
  [[nodiscard]] const Member* FindByName(const std::string& name) const;
  [[nodiscard]] Error NameInUse(const Member& member) const;
  void Enter(const message::Join& join, const std::string& link, std::int64_t now);
  void Apply(CatalogChange change);
  void SetState(const std::string& process, ProcessState state, const std::string& reason);
  void SuspendConnections(const std::string& process);
  void Forgive(SteadyTime now);
  void ClearTombstones(SteadyTime now);
  void Remove(const std::string& process);

  const Leases leases_;
  const Clock& clock_;
  Catalog catalog_;
  DescriptionPool pool_;
  std::map<Session, Member> members_;
  std::map<std::string, SteadyTime> tombstones_;  // since when
  /// Starting, with what the catalogue had before.
  std::map<std::string, std::optional<ProcessDescription>> expected_;
  HandBacks hand_backs_;
  bool look_for_hand_backs_ = false;
  std::vector<CatalogChange> changes_;
  SteadyTime last_tick_ = clock_.Now();
};

}  // namespace tendon::server
