#include "support/sample_system.h"

#include <functional>
#include <utility>

namespace tendon::gui {
namespace {

Fingerprint Print(const std::string& type) { return {std::hash<std::string>{}(type), type.size()}; }

MemberDescription Member(CommandKind kind, const std::string& name, const std::string& in,
                         const std::string& out) {
  MemberDescription member;
  member.name = name;
  member.signature = {kind, Print(in), Print(out)};
  member.in_type = in;
  member.out_type = out;
  return member;
}

ProvidedDescription Provided(const std::string& name, std::vector<MemberDescription> commands,
                             std::vector<MemberDescription> events = {}) {
  return {name, std::move(commands), std::move(events)};
}

RequiredDescription Required(const std::string& name, std::vector<MemberDescription> functions,
                             std::vector<MemberDescription> handlers = {}) {
  return {name, std::move(functions), std::move(handlers), false};
}

ComponentDescription With(ComponentDescription component, std::vector<RequiredDescription> required,
                          std::vector<ProvidedDescription> provided) {
  component.required = std::move(required);
  for (const auto& own : std::as_const(component).provided) provided.push_back(own);
  component.provided = std::move(provided);
  return component;
}

void AddRobot(SystemBuilder& system) {
  system.Process("robot");
  system.Component("robot", With(Task("arm", 1e-3, {Column("Joints", "arm.JointState")}), {},
                                 {Provided("Drives",
                                           {Write("SetTorques", "arm.JointTorques"), Void("Stop"),
                                            Read("GetJoints", "arm.JointState")},
                                           {Write("LimitExceeded", "arm.LimitFault")})}));
  system.Component("robot", With(Task("force_sensor", 2e-3, {Column("Wrench", "arm.Wrench")}), {},
                                 {Provided("Wrench", {Read("GetWrench", "arm.Wrench")})}));
  system.Component(
      "robot", With(Task("controller", 1e-3, {Column("Goal", "arm.JointState")}),
                    {Required("Arm", {Write("SetTorques", "arm.JointTorques"),
                                      Read("GetJoints", "arm.JointState")}),
                     Required("Force", {Read("GetWrench", "arm.Wrench")})},
                    {Provided("Control", {Write("MoveTo", "arm.JointGoal"),
                                          Read("GetJoints", "arm.JointState"), Void("Stop")})}));
  system.Connect({"robot", "controller", "Arm"}, {"robot", "arm", "Drives"});
  system.Connect({"robot", "controller", "Force"}, {"robot", "force_sensor", "Wrench"});
}

void AddDesk(SystemBuilder& system) {
  system.Process("desk");
  system.Component("desk", With(Task("teleoperation", 0.02, {Column("Goal", "arm.JointGoal")}),
                                {Required("Robot", {Write("MoveTo", "arm.JointGoal"),
                                                    Read("GetJoints", "arm.JointState")})},
                                {}));
  system.Component("desk", Task("host_monitor", 0.05, {Column("Host", "host.Load")}));
  system.Component("desk",
                   With(Task("view", 0, {}), {Required("Host", {Read("Host", "host.Load")})}, {}));
  system.Connect({"desk", "view", "Host"}, {"desk", "host_monitor", "state"});
}

}  // namespace

SystemBuilder& SystemBuilder::Apply(CatalogueChange change) {
  change.revision = catalogue_.revision() + 1;
  if (catalogue_.Apply(change)) changes_.push_back(std::move(change));
  return *this;
}

SystemBuilder& SystemBuilder::Process(const std::string& name, ProcessState state,
                                      std::int64_t since, std::uint64_t instance,
                                      const std::string& reason) {
  ProcessDescription process;
  process.name = name;
  process.instance = instance;
  process.host = "localhost";
  process.pid = 4711;
  process.address = "127.0.0.1:40001";
  process.state = state;
  process.since = since;
  const bool is_lost_somehow = state == ProcessState::kLost && reason.empty();
  process.reason = is_lost_somehow ? "its connection broke" : reason;
  return Process(process);
}

SystemBuilder& SystemBuilder::Process(const ProcessDescription& process) {
  CatalogueChange change;
  change.kind = CatalogueChange::Kind::kProcess;
  change.process = process.name;
  change.processes = {process};
  return Apply(std::move(change));
}

SystemBuilder& SystemBuilder::RemoveProcess(const std::string& name) {
  CatalogueChange change;
  change.kind = CatalogueChange::Kind::kProcessRemoved;
  change.process = name;
  return Apply(std::move(change));
}

SystemBuilder& SystemBuilder::Component(const std::string& process,
                                        const ComponentDescription& component) {
  CatalogueChange change;
  change.kind = CatalogueChange::Kind::kComponent;
  change.process = process;
  change.components = {component};
  return Apply(std::move(change));
}

SystemBuilder& SystemBuilder::RemoveComponent(const std::string& process,
                                              const std::string& component) {
  CatalogueChange change;
  change.kind = CatalogueChange::Kind::kComponentRemoved;
  change.process = process;
  change.component = component;
  return Apply(std::move(change));
}

SystemBuilder& SystemBuilder::Connect(const InterfaceName& required, const InterfaceName& provided,
                                      ConnectionState state, const std::string& reason) {
  const auto* known = catalogue_.FindConnection(required);
  CatalogueChange change;
  change.kind = CatalogueChange::Kind::kConnection;
  change.process = required.process;
  change.connections = {
      {known != nullptr ? known->id : ++last_connection_, required, provided, state, reason}};
  return Apply(std::move(change));
}

SystemBuilder& SystemBuilder::Disconnect(const InterfaceName& required) {
  const auto* known = catalogue_.FindConnection(required);
  if (known == nullptr) return *this;
  CatalogueChange change;
  change.kind = CatalogueChange::Kind::kConnectionRemoved;
  change.process = required.process;
  change.connection = known->id;
  return Apply(std::move(change));
}

std::vector<CatalogueChange> SystemBuilder::TakeChanges() { return std::exchange(changes_, {}); }

MemberDescription Write(const std::string& name, const std::string& type) {
  return Member(CommandKind::kWrite, name, type, {});
}

MemberDescription Read(const std::string& name, const std::string& type) {
  return Member(CommandKind::kRead, name, {}, type);
}

MemberDescription Void(const std::string& name) { return Member(CommandKind::kVoid, name, {}, {}); }

ColumnDescription Column(const std::string& name, const std::string& type) {
  return {name, type, Print(type)};
}

ComponentDescription Task(const std::string& name, double period,
                          std::vector<ColumnDescription> columns) {
  ComponentDescription component;
  component.name = name;
  component.class_name = "demo::" + name;
  component.state = ComponentState::kActive;
  component.period = period;
  if (period > 0) {
    columns.push_back(Column("Cycle", "tendon.CycleStatistics"));
    columns.push_back(Column("CycleSummary", "tendon.CycleSummary"));
  }
  if (columns.empty()) return component;
  std::vector<MemberDescription> reads;
  for (const auto& column : columns) reads.push_back(Read(column.name, column.type));
  component.provided.push_back(Provided("state", std::move(reads)));
  component.tables.push_back({"state", 1000, std::move(columns)});
  return component;
}

SystemBuilder LookSystem(std::int64_t lost_since) {
  SystemBuilder system;
  AddRobot(system);
  AddDesk(system);
  system.Process("vision");
  system.Component("vision", With(Task("camera", 0.04, {}), {},
                                  {Provided("Video", {Read("GetFrame", "vision.Frame")})}));
  system.Process("vision", ProcessState::kLost, lost_since);
  return system;
}

}  // namespace tendon::gui
