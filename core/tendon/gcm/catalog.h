#pragma once

#include <tendon/process/description.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tendon {

/// A process and what it holds.
struct ProcessEntry {
  ProcessDescription process;
  std::map<std::string, ComponentDescription> components;
  std::map<std::uint64_t, ConnectionDescription> connections;  ///< those it owns, by id

  bool operator==(const ProcessEntry&) const = default;
};

/// All that is known of the system: processes, their components with interfaces and members, and
/// connections. A plain value: copy it, compare it, apply changes to it. Not thread-safe.
class Catalog {
 public:
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  [[nodiscard]] const std::map<std::string, ProcessEntry>& processes() const { return processes_; }

  /// Null where there is none.
  [[nodiscard]] const ProcessEntry* FindProcess(const std::string& name) const;
  [[nodiscard]] const ComponentDescription* FindComponent(const std::string& process,
                                                          const std::string& component) const;
  [[nodiscard]] const ProvidedDescription* FindProvided(const InterfaceName& name) const;
  [[nodiscard]] const RequiredDescription* FindRequired(const InterfaceName& name) const;
  /// The connection of a required interface, if it has one.
  [[nodiscard]] const ConnectionDescription* FindConnection(const InterfaceName& required) const;
  [[nodiscard]] std::vector<ConnectionDescription> connections() const;

  /// Applies the next change; false, and nothing happens, when its revision does not follow or it
  /// makes no sense (the watcher then asks for a snapshot).
  [[nodiscard]] bool Apply(const CatalogChange& change);

  /// The changes that build this catalogue from an empty one of revision `revision() - size`; a
  /// snapshot is sent that way.
  [[nodiscard]] std::vector<CatalogChange> AsChanges() const;

  /// Empty, at this revision: where a snapshot begins.
  static Catalog At(std::uint64_t revision);

  /// Of everything but pids, instances, times, addresses, connection ids, reasons and warnings: two
  /// systems that look alike to their users have the same.
  [[nodiscard]] Fingerprint ContentHash() const;

  bool operator==(const Catalog&) const = default;

 private:
  std::uint64_t revision_ = 0;
  std::map<std::string, ProcessEntry> processes_;
};

}  // namespace tendon
