#include <gcm_console/catalogue/system_items.h>

#include <gcm_console/catalogue/path_target.h>
#include <gcm_console/catalogue/telemetry_column.h>
#include <tendon/gcm/waiting.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

namespace console {
namespace {

using tendon::Catalogue;
using tendon::InterfaceName;

/// The clients of each provided interface. They are collected once, so that long lists are fast.
using Users = std::map<InterfaceName, std::vector<InterfaceName>>;

std::string TextOf(const std::vector<InterfaceName>& users) {
  if (users.empty()) return "";
  const std::size_t more = users.size() - 1;
  return "<- " + ToString(users[0]) + (more == 0 ? "" : " and " + std::to_string(more) + " more");
}

/// Returns the problem of a component, or the reason why it waits.
std::string DetailOf(const tendon::ProcessEntry& entry,
                     const tendon::ComponentDescription& component) {
  if (!component.fault.empty()) return component.fault;
  const std::string waiting = WaitingReasons(WaitsOf(entry, component));
  const bool is_both = !component.warning.empty() && !waiting.empty();
  return component.warning + (is_both ? "; " : "") + waiting;
}

class ItemCollector {
 public:
  ItemCollector(const Catalogue& catalogue, const std::string& below)
      : catalogue_(catalogue), below_(below) {
    for (const auto& connection : catalogue.connections()) {
      users_[connection.provided].push_back(connection.required);
    }
  }

  void Go() {
    for (const auto& [name, entry] : catalogue_.processes()) {
      host_ = entry.process.host;
      Add(name, "process", "", std::string(ToString(entry.process.state)), entry.process.reason);
      for (const auto& [component, description] : entry.components) Go(entry, description);
    }
  }
  std::vector<SystemItem> Take() { return std::move(items_); }

 private:
  void Go(const tendon::ProcessEntry& entry, const tendon::ComponentDescription& component) {
    const std::string& process = entry.process.name;
    Add(process + "/" + component.name, "component", component.class_name,
        std::string(ToString(component.state)), DetailOf(entry, component));
    for (const auto& one : component.provided) {
      const InterfaceName name(process, component.name, one.name);
      const auto users = users_.find(name);
      Add(ToString(name), "provided interface", "", users == users_.end() ? "" : "connected",
          users == users_.end() ? "" : TextOf(users->second));
      AddMembers(name, IsTable(one.name) ? "column" : "command", one.commands);
      AddMembers(name, "event", one.events);
    }
    for (const auto& one : component.required) {
      const InterfaceName name(process, component.name, one.name);
      const auto* connection = catalogue_.FindConnection(name);
      Add(ToString(name), "required interface", "",
          connection == nullptr ? "" : std::string(ToString(connection->state)),
          ProviderOf(catalogue_, name));
      AddMembers(name, "function", one.functions);
      AddMembers(name, "event handler", one.event_handlers);
    }
  }
  void AddMembers(const InterfaceName& interface, std::string_view kind,
                  const std::vector<tendon::MemberDescription>& members) {
    for (const auto& member : members) {
      Add(ToString(interface) + "." + member.name, kind, TypesOf(member), "", "");
    }
  }
  void Add(std::string path, std::string_view kind, std::string type, std::string state,
           std::string detail) {
    const bool is_below =
        below_.empty() || path.starts_with(below_ + "/") || path.starts_with(below_ + ".");
    if (!is_below) return;
    items_.push_back({.path = std::move(path),
                      .kind = kind,
                      .type = std::move(type),
                      .state = std::move(state),
                      .detail = std::move(detail),
                      .host = host_});
  }

  const Catalogue& catalogue_;
  const std::string below_;
  Users users_;
  std::string host_;
  std::vector<SystemItem> items_;
};

}  // namespace

std::vector<SystemItem> ItemsIn(const Catalogue& catalogue, const std::string& path) {
  ItemCollector collector(catalogue, path);
  collector.Go();
  return collector.Take();
}

void PrintItems(Context& context, const std::vector<SystemItem>& items) {
  if (context.settings().json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const SystemItem& item : items) {
      all.push_back({{"path", item.path},
                     {"what", item.kind},
                     {"type", item.type},
                     {"state", item.state},
                     {"detail", item.detail},
                     {"host", item.host}});
    }
    context.PrintJson({{"things", std::move(all)}});
    return;
  }
  Table table({"PATH", "WHAT", "TYPE", "STATE", "DETAIL"});
  for (const SystemItem& item : items) {
    table.Add({item.path, std::string(item.kind), item.type, item.state, item.detail});
  }
  context.Print(table);
}

int DepthOf(const std::string& path) {
  if (path.empty()) return 0;
  return 1 + static_cast<int>(std::count_if(path.begin(), path.end(), [](char letter) {
           return letter == '/' || letter == '.';
         }));
}

std::string ProviderOf(const Catalogue& catalogue, const InterfaceName& required) {
  const auto* connection = catalogue.FindConnection(required);
  if (connection == nullptr) return "not connected";
  const std::string provider = "-> " + ToString(connection->provided);
  if (connection->state == tendon::ConnectionState::kActive) return provider;
  return provider + " (" + std::string(ToString(connection->state)) + ": " + connection->reason +
         ")";
}

std::string UsersOf(const Catalogue& catalogue, const InterfaceName& provided) {
  std::vector<InterfaceName> users;
  for (const auto& connection : catalogue.connections()) {
    if (connection.provided == provided) users.push_back(connection.required);
  }
  return TextOf(users);
}

}  // namespace console
