#pragma once

#include <tendon/process/process_description.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tendon {

/// A process with its components and connections.
struct ProcessEntry {
  ProcessDescription process;
  std::map<std::string, ComponentDescription> components;
  std::map<std::uint64_t, ConnectionDescription> connections;  ///< its own connections, by id

  bool operator==(const ProcessEntry&) const = default;
};

/// Everything that is known of a system: processes, their components with interfaces and members,
/// and connections. A plain value, which can be copied, compared and changed. Not thread-safe.
class Catalogue {
 public:
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  [[nodiscard]] const std::map<std::string, ProcessEntry>& processes() const { return processes_; }

  /// Null if there is none.
  [[nodiscard]] const ProcessEntry* FindProcess(const std::string& name) const;
  [[nodiscard]] const ComponentDescription* FindComponent(const std::string& process,
                                                          const std::string& component) const;
  [[nodiscard]] const ProvidedDescription* FindProvided(const InterfaceName& name) const;
  [[nodiscard]] const RequiredDescription* FindRequired(const InterfaceName& name) const;
  /// The connection of a required interface, if it has one.
  [[nodiscard]] const ConnectionDescription* FindConnection(const InterfaceName& required) const;
  [[nodiscard]] std::vector<ConnectionDescription> connections() const;

  /// Applies the next change. Returns false, without an effect, if the change is invalid or its
  /// revision is not the next one. Then the watcher asks for a snapshot.
  [[nodiscard]] bool Apply(const CatalogueChange& change);

  /// The changes that build this catalogue from an empty one of revision `revision() - size`.
  /// Snapshots are sent in this form.
  [[nodiscard]] std::vector<CatalogueChange> AsChanges() const;

  /// An empty catalogue of this revision, as the start for applying a snapshot.
  static Catalogue At(std::uint64_t revision);

  /// A hash of everything except pids, instances, times, addresses, connection ids, reasons and
  /// warnings. Equal for two systems that look the same to users.
  [[nodiscard]] Fingerprint ContentHash() const;

  bool operator==(const Catalogue&) const = default;

 private:
  std::uint64_t revision_ = 0;
  std::map<std::string, ProcessEntry> processes_;
};

}  // namespace tendon
