#include <gcm_console/output/catalogue_json.h>

#include <gcm_console/catalogue/path_target.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text.h>
#include <tendon/gcm/waiting.h>
#include <tendon/payload/json.h>
#include <tendon/payload/json/strict_json.h>

#include <chrono>
#include <nlohmann/json.hpp>

namespace console {
namespace {

using nlohmann::ordered_json;

template <typename List>
ordered_json ListOf(const List& list) {
  ordered_json all = ordered_json::array();
  for (const auto& one : list) all.push_back(ToJson(one));
  return all;
}

/// Returns null if the component never has its own thread.
ordered_json ThreadOf(const tendon::ComponentDescription& component) {
  if (component.thread.empty()) return nullptr;
  return tendon::JsonOrText(tendon::ToJson(component.thread.front()));
}

}  // namespace

ordered_json ToJson(const tendon::ProcessEntry& entry) {
  ordered_json components = ordered_json::array();
  for (const auto& [name, component] : entry.components) {
    components.push_back(ToJson(component, entry));
  }
  ordered_json connections = ordered_json::array();
  for (const auto& [id, connection] : entry.connections) connections.push_back(ToJson(connection));
  return {{"name", entry.process.name},
          {"state", ToString(entry.process.state)},
          {"reason", entry.process.reason},
          {"host", entry.process.host},
          {"pid", entry.process.pid},
          {"address", entry.process.address},
          {"plugins", ListOf(entry.process.plugins)},
          {"components", std::move(components)},
          {"connections", std::move(connections)}};
}

ordered_json ToJson(const tendon::PluginDescription& plugin) {
  return {{"library", plugin.name},
          {"file", plugin.file},
          {"written", tendon::WallTimeText(plugin.written)},
          {"state", ToString(plugin.state)},
          {"written_now", plugin.written_now == 0 ? "" : tendon::WallTimeText(plugin.written_now)}};
}

ordered_json ToJson(const tendon::ComponentDescription& component,
                    const tendon::ProcessEntry& process) {
  ordered_json waits = ordered_json::array();
  for (const tendon::UnsatisfiedInterface& need : WaitsOf(process, component)) {
    waits.push_back({{"required", need.interface}, {"reason", need.reason}});
  }
  ordered_json tables = ordered_json::array();
  for (const auto& table : component.tables) {
    ordered_json columns = ordered_json::array();
    for (const auto& column : table.columns) {
      columns.push_back({{"name", column.name}, {"type", column.type}});
    }
    tables.push_back({{"name", table.name}, {"rows", table.length}, {"columns", columns}});
  }
  return {{"name", component.name},
          {"class", component.class_name},
          {"library", component.library},
          {"configuration", component.configuration},
          {"state", ToString(component.state)},
          {"waiting_for", std::move(waits)},
          {"fault", component.fault},
          {"fault_time", component.fault_time},
          {"period", component.period},
          {"thread", ThreadOf(component)},
          {"runs_after", component.leader},
          {"provided", ListOf(component.provided)},
          {"required", ListOf(component.required)},
          {"tables", std::move(tables)}};
}

ordered_json ToJson(const tendon::ProvidedDescription& interface) {
  return {{"name", interface.name},
          {"commands", ListOf(interface.commands)},
          {"events", ListOf(interface.events)}};
}

ordered_json ToJson(const tendon::RequiredDescription& interface) {
  return {{"name", interface.name},
          {"optional", interface.optional},
          {"functions", ListOf(interface.functions)},
          {"event_handlers", ListOf(interface.event_handlers)}};
}

ordered_json ToJson(const tendon::MemberDescription& member) {
  ordered_json json = {{"name", member.name}, {"kind", ToString(member.signature.kind)}};
  if (TakesArgument(member.signature)) json["in"] = member.in_type;
  if (HasResult(member)) json["out"] = member.out_type;
  if (member.optional) json["optional"] = true;
  if (!member.hazard.empty()) json["hazard"] = member.hazard;
  if (member.expires_after > 0.0) json["expires_after"] = member.expires_after;
  return json;
}

ordered_json ToJson(const tendon::ConnectionDescription& connection) {
  return {{"id", connection.id},
          {"required", ToString(connection.required)},
          {"provided", ToString(connection.provided)},
          {"state", ToString(connection.state)},
          {"reason", connection.reason}};
}

ordered_json ToJson(const tendon::ConnectionCounts& counts) {
  using Seconds = std::chrono::duration<double>;
  ordered_json json = {{"age_s", Seconds(counts.age).count()},
                       {"taken", counts.taken},
                       {"waiting", counts.waiting},
                       {"capacity", counts.capacity},
                       {"refused", counts.refused},
                       {"replaced", counts.replaced},
                       {"lost_events", counts.lost_events}};
  if (counts.round_trip.count() >= 0) json["round_trip_s"] = Seconds(counts.round_trip).count();
  return json;
}

ordered_json ToJson(const tendon::MailboxFill& fill) {
  return {{"waiting", fill.waiting}, {"capacity", fill.capacity}};
}

ordered_json ToJson(const tendon::message::ProcessHistoryState& history) {
  using Seconds = std::chrono::duration<double>;
  if (history.limit == 0) return {{"limit_bytes", 0}};
  return {{"memory_bytes", history.memory},          {"limit_bytes", history.limit},
          {"span_s", Seconds(history.span).count()}, {"reach_s", Seconds(history.reach).count()},
          {"missed_rows", history.missed_rows},      {"missed_events", history.missed_events}};
}

ordered_json HealthOf(const tendon::message::SystemHealth& health,
                      const tendon::ProcessDescription& process) {
  using Seconds = std::chrono::duration<double>;
  const auto* const found = LastHealth(health, process);
  ordered_json json = ordered_json::object();
  if (found == nullptr) return json;
  if (found->cpu >= 0.0) json["cpu_cores"] = found->cpu;
  if (found->memory > 0) json["memory_bytes"] = found->memory;
  if (found->clock_uncertainty >= std::chrono::nanoseconds(0)) {
    json["clock_offset_s"] = Seconds(found->clock_offset).count();
    json["clock_uncertainty_s"] = Seconds(found->clock_uncertainty).count();
  }
  json["age_s"] = Seconds(found->age).count();
  return json;
}

}  // namespace console
