#pragma once

#include <tendon/base/clock.h>
#include <tendon/process/client/peer_link.h>
#include <tendon/process/description.h>

#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tendon {

/// The other processes: which there are, and the links to those that are needed. On the worker
/// only.
class Peers {
 public:
  Peers(ProcessContext& context, PeerListener& listener) : context_(context), listener_(listener) {}

  /// All that there are, as the GCM says. Links stand, whatever it says: it may not know yet.
  void Update(const std::vector<ProcessDescription>& processes);
  /// One of them.
  void Learn(const std::string& process, const std::string& address, std::uint64_t instance);

  [[nodiscard]] std::vector<std::string> names() const;
  /// Which instance of it is there; nothing when it is not.
  [[nodiscard]] std::optional<std::uint64_t> InstanceOf(const std::string& process) const;

  using Done = PeerLink::Opened;

  /// The link to it, opened if need be; `done` is called at once where there is nothing to open.
  /// Those who did not answer the last time wait behind the others, and for one another.
  void LinkTo(const std::string& process, Done done);
  /// Closes links to other instances than the one that is there, and those to processes that the
  /// GCM has lost where we hear nothing of them either.
  void CloseOutdated();
  void CloseAll();

 private:
  struct Place {
    std::string address;
    std::uint64_t instance = 0;

    bool operator==(const Place&) const = default;
  };

  /// It accepts connections and does not answer: not asked again for a while, for that would hold
  /// up those that do.
  struct Silence {
    Place place;
    Error error;
    std::chrono::milliseconds rest{0};
    SteadyTime until{};
  };

  void Open(const std::string& process);
  void Finish(const std::string& process, const Place& tried,
              const Result<std::shared_ptr<PeerLink>>& opened);
  void Remember(const std::string& process, const Place& tried,
                const Result<std::shared_ptr<PeerLink>>& opened);

  ProcessContext& context_;
  PeerListener& listener_;
  std::map<std::string, Place> places_;
  std::map<std::string, std::shared_ptr<PeerLink>> links_;
  std::map<std::string, std::vector<Done>> openings_;  // and who waits for each
  std::map<std::string, Silence> silences_;
  std::deque<std::string> silent_;  // to be opened; the first of them is
};

}  // namespace tendon
