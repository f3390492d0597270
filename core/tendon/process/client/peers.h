#pragma once

#include <tendon/base/clock.h>
#include <tendon/process/client/peer_link.h>
#include <tendon/process/description.h>

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

  /// The link to it, opened if need be, which blocks for at most a second.
  Result<std::shared_ptr<PeerLink>> LinkTo(const std::string& process);
  /// Closes links to other instances than the one that is there.
  void CloseOutdated();
  void CloseAll();

 private:
  struct Place {
    std::string address;
    std::uint64_t instance = 0;
  };

  /// It accepts connections and does not answer: not asked again for a while, for that would block
  /// the worker once for each connection to it.
  struct Silence {
    std::string address;
    SteadyTime until{};
    Error error;
  };

  ProcessContext& context_;
  PeerListener& listener_;
  std::map<std::string, Place> places_;
  std::map<std::string, std::shared_ptr<PeerLink>> links_;
  std::map<std::string, Silence> silences_;
};

}  // namespace tendon
