#pragma once

#include <tendon/gcm/catalogue.h>

#include <cstdint>
#include <string>
#include <vector>

namespace tendon::gui {

/// Builds a catalogue step by step, as the changes of a GCM would.
class SystemBuilder {
 public:
  /// `reason` says why the process is lost. For a living process, it says which hosts cannot reach
  /// the process.
  SystemBuilder& Process(const std::string& name, ProcessState state = ProcessState::kAlive,
                         std::int64_t since = 0, std::uint64_t instance = 1,
                         const std::string& reason = {});
  SystemBuilder& Process(const ProcessDescription& process);
  SystemBuilder& RemoveProcess(const std::string& name);
  SystemBuilder& Component(const std::string& process, const ComponentDescription& component);
  SystemBuilder& RemoveComponent(const std::string& process, const std::string& component);
  SystemBuilder& Connect(const InterfaceName& required, const InterfaceName& provided,
                         ConnectionState state = ConnectionState::kActive,
                         const std::string& reason = {});
  SystemBuilder& Disconnect(const InterfaceName& required);

  [[nodiscard]] const Catalogue& catalogue() const { return catalogue_; }
  /// Returns the changes since the last call, so that they can be applied to another copy.
  [[nodiscard]] std::vector<CatalogueChange> TakeChanges();

 private:
  SystemBuilder& Apply(CatalogueChange change);

  Catalogue catalogue_ = Catalogue::At(0);
  std::vector<CatalogueChange> changes_;
  std::uint64_t last_connection_ = 0;
};

// Short forms for descriptions. The fingerprint of a type is computed from the name of the type.
MemberDescription Write(const std::string& name, const std::string& type);
MemberDescription Read(const std::string& name, const std::string& type);
MemberDescription Void(const std::string& name);

/// An active component with a state table of these columns (and, if it has a period, `Cycle`
/// and `CycleSummary`).
ComponentDescription Task(const std::string& name, double period,
                          std::vector<ColumnDescription> columns);
ColumnDescription Column(const std::string& name, const std::string& type);

/// The system in the reference pictures: robot with arm, force_sensor and controller; desk with
/// teleoperation, host_monitor and view; and vision, which is lost since `lost_since`.
SystemBuilder LookSystem(std::int64_t lost_since);

}  // namespace tendon::gui
