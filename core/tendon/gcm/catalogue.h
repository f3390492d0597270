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

/// All known parts of a system: processes, their components with interfaces and members, and
/// connections. A plain value, which can be copied, compared and changed. Not thread-safe.
class Catalogue {
 public:
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  [[nodiscard]] const std::map<std::string, ProcessEntry>& processes() const { return processes_; }

  /// The Find functions return null if the object is not in the catalogue.
  [[nodiscard]] const ProcessEntry* FindProcess(const std::string& name) const;
  [[nodiscard]] const ComponentDescription* FindComponent(const std::string& process,
                                                          const std::string& component) const;
  [[nodiscard]] const ProvidedDescription* FindProvided(const InterfaceName& name) const;
  [[nodiscard]] const RequiredDescription* FindRequired(const InterfaceName& name) const;
  /// Finds the connection of a required interface.
  [[nodiscard]] const ConnectionDescription* FindConnection(const InterfaceName& required) const;
  [[nodiscard]] std::vector<ConnectionDescription> connections() const;

  /// Applies the next change. Returns false and changes nothing if the change is invalid, or if its
  /// revision does not follow revision(). The watcher then has to ask for a snapshot.
  [[nodiscard]] bool Apply(const CatalogueChange& change);

  /// Returns the changes that build this catalogue. They are applied to the empty catalogue
  /// At(revision() - N), where N is the number of changes. Snapshots are sent in this form.
  [[nodiscard]] std::vector<CatalogueChange> AsChanges() const;

  /// Returns an empty catalogue with this revision, to which the changes of a snapshot can be
  /// applied.
  static Catalogue At(std::uint64_t revision);

  /// Returns a hash of all data in which users can see a difference. It does not cover pids,
  /// instances, times, addresses, connection ids, reasons and warnings.
  [[nodiscard]] Fingerprint ContentHash() const;

  bool operator==(const Catalogue&) const = default;

 private:
  std::uint64_t revision_ = 0;
  std::map<std::string, ProcessEntry> processes_;
};

}  // namespace tendon
