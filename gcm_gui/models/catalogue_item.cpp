#include <gcm_gui/models/catalogue_item.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/table_columns.h>
#include <gcm_gui/models/text.h>

#include <QStringList>
#include <algorithm>

namespace tendon::gui {
namespace {

using Item = std::unique_ptr<CatalogueItem>;

Item MakeItem(ItemKind kind, const QString& name, const QString& path) {
  auto item = std::make_unique<CatalogueItem>();
  item->kind = kind;
  item->name = name;
  item->path = path;
  item->folded = path.toLower();
  return item;
}

void AddMembers(CatalogueItem& interface, ItemKind kind,
                const std::vector<MemberDescription>& members) {
  for (const auto& member : members) {
    const QString name = ToQString(member.name);
    Item item = MakeItem(kind, name, interface.path + '.' + name);
    item->detail = TypesText(member, TypeNames::kWhole);
    const bool command = kind == ItemKind::kCommand || kind == ItemKind::kFunction;
    item->value = command ? ToQString(ToString(member.signature.kind)) : KindWord(kind);
    item->gone = interface.gone;
    interface.Add(std::move(item));
  }
}

const TableDescription* FindTable(const ComponentDescription& component, const std::string& name) {
  const auto it = std::find_if(component.tables.begin(), component.tables.end(),
                               [&](const auto& table) { return table.name == name; });
  return it == component.tables.end() ? nullptr : &*it;
}

void AddColumns(CatalogueItem& interface, const TableDescription& table) {
  for (const auto* column : ColumnsOf(table)) {
    const QString name = ToQString(column->name);
    Item item = MakeItem(ItemKind::kColumn, name, interface.path + '.' + name);
    item->detail = ToQString(column->type);
    item->type = column->fingerprint;
    item->gone = interface.gone;
    interface.Add(std::move(item));
  }
}

/// Returns "arm", or "robot/arm" if the component is in another process than `process`.
QString ComponentSeenFrom(const std::string& process, const InterfaceName& other) {
  const QString name = ToQString(other.component);
  return other.process == process ? name : ToQString(other.process) + '/' + name;
}

/// Returns "arm/Drives"; with the process before it if the interface is in another process than
/// `process`.
QString NameSeenFrom(const std::string& process, const InterfaceName& other) {
  return ComponentSeenFrom(process, other) + '/' + ToQString(other.interface);
}

void ShowConnection(CatalogueItem& item, const std::string& process,
                    const ConnectionDescription* connection) {
  item.mark = MarkOf(connection);
  item.state = KeyOf(*item.mark);
  item.value = WordOf(*item.mark);
  item.connected = QString();
  if (connection == nullptr) return;
  if (connection->state == ConnectionState::kActive) {
    item.connected = NameSeenFrom(process, connection->provided);
  }
  item.value = QStringLiteral("← ") + ToQString(connection->provided.component) + '/' +
               ToQString(connection->provided.interface);
  item.detail = ToQString(connection->reason);
}

Item BuildProvided(const ConnectionIndex& connections, const CatalogueItem& parent,
                   const InterfaceName& name, const ComponentDescription& component,
                   const ProvidedDescription& provided) {
  Item item =
      MakeItem(ItemKind::kProvided, ToQString(provided.name), ToQString(tendon::ToString(name)));
  item->gone = parent.gone;
  item->value =
      CountText(connections.Clients(name), Words::tr("%1 client"), Words::tr("%1 clients"));
  QStringList clients;
  for (const auto& client : connections.ClientsOf(name)) {
    clients << NameSeenFrom(name.process, client);
  }
  item->connected = clients.join(QStringLiteral(", "));
  if (const auto* table = FindTable(component, provided.name)) {
    AddColumns(*item, *table);
  } else {
    AddMembers(*item, ItemKind::kCommand, provided.commands);
  }
  AddMembers(*item, ItemKind::kEvent, provided.events);
  return item;
}

Item BuildRequired(const ConnectionIndex& connections, const CatalogueItem& parent,
                   const InterfaceName& name, const RequiredDescription& required) {
  Item item =
      MakeItem(ItemKind::kRequired, ToQString(required.name), ToQString(tendon::ToString(name)));
  item->gone = parent.gone;
  ShowConnection(*item, name.process, connections.Of(name));
  AddMembers(*item, ItemKind::kFunction, required.functions);
  AddMembers(*item, ItemKind::kHandler, required.event_handlers);
  return item;
}

/// Returns the peers of all interfaces of the component.
QString PeersOf(const ConnectionIndex& connections, const std::string& process,
                const ComponentDescription& component) {
  QStringList peers;
  for (const auto& required : component.required) {
    const auto* connection = connections.Of({process, component.name, required.name});
    if (connection != nullptr && connection->state == ConnectionState::kActive) {
      peers << ComponentSeenFrom(process, connection->provided);
    }
  }
  for (const auto& provided : component.provided) {
    for (const auto& client : connections.ClientsOf({process, component.name, provided.name})) {
      peers << ComponentSeenFrom(process, client);
    }
  }
  peers.sort();
  peers.removeDuplicates();
  return peers.join(QStringLiteral(", "));
}

/// Splits ".position[0]" into ".position" and "[0]".
std::vector<QString> Segments(const std::string& path) {
  std::vector<QString> segments;
  for (std::size_t begin = 0; begin < path.size();) {
    const std::size_t end = std::min(path.find_first_of(".[", begin + 1), path.size());
    segments.push_back(ToQString(std::string_view(path).substr(begin, end - begin)));
    begin = end;
  }
  return segments;
}

/// Returns the last child if it has this segment, otherwise a new child. Only the last child can
/// have the segment, because the fields are in the order of the wire format.
CatalogueItem& Group(CatalogueItem& parent, const QString& segment) {
  const QString path = parent.path + segment;
  if (!parent.children.empty() && parent.children.back()->path == path) {
    return *parent.children.back();
  }
  const QString name = segment.startsWith('.') ? segment.mid(1) : segment;
  Item item = MakeItem(ItemKind::kGroup, name, path);
  item->gone = parent.gone;
  return parent.Add(std::move(item));
}

/// If all numbers of a group have the same unit, shows the unit at the group instead of at each
/// number.
void LiftUnits(CatalogueItem& item) {
  for (const auto& child : item.children) LiftUnits(*child);
  if (item.children.empty()) return;
  const QString unit = item.children.front()->unit;
  const bool same = std::all_of(item.children.begin(), item.children.end(),
                                [&](const auto& child) { return child->unit == unit; });
  if (same) item.unit = unit;
}

}  // namespace

CatalogueItem& CatalogueItem::Add(std::unique_ptr<CatalogueItem> child) {
  child->parent = this;
  child->row = static_cast<int>(children.size());
  children.push_back(std::move(child));
  return *children.back();
}

int CatalogueItem::Count() const {
  int count = 1;
  for (const auto& child : children) count += child->Count();
  return count;
}

QString KindWord(ItemKind kind) {
  switch (kind) {
    case ItemKind::kProcess:
      return QStringLiteral("process");
    case ItemKind::kComponent:
      return QStringLiteral("component");
    case ItemKind::kProvided:
      return QStringLiteral("provided");
    case ItemKind::kRequired:
      return QStringLiteral("required");
    case ItemKind::kCommand:
      return QStringLiteral("command");
    case ItemKind::kEvent:
      return QStringLiteral("event");
    case ItemKind::kFunction:
      return QStringLiteral("function");
    case ItemKind::kHandler:
      return QStringLiteral("handler");
    case ItemKind::kColumn:
      return QStringLiteral("column");
    case ItemKind::kGroup:
      return QStringLiteral("field");
    case ItemKind::kField:
      return QStringLiteral("value");
  }
  return {};
}

std::unique_ptr<CatalogueItem> BuildComponent(const ConnectionIndex& connections,
                                              const ProcessEntry& entry,
                                              const ComponentDescription& component) {
  const std::string& process = entry.process.name;
  Item item = MakeItem(ItemKind::kComponent, ToQString(component.name),
                       ToQString(process + '/' + component.name));
  item->gone = IsGone(entry.process.state);
  item->still = StaleReasonOf(entry.process.state, component.state);
  item->state = item->gone ? QStringLiteral("lost") : ToQString(ToString(component.state));
  item->detail = ToQString(component.class_name);
  item->connected = PeersOf(connections, process, component);
  if (!item->gone) {
    const auto waits = WaitsOf(connections, entry, component);
    item->mark = MarkOf(component.state, waits);
    const bool works = component.state == ComponentState::kActive && waits.empty();
    item->value = works && component.period > 0 ? RateOfPeriodText(component.period)
                                                : WordOf(component.state, waits);
    if (!waits.empty()) {
      item->detail += QStringLiteral("\n") + Words::tr("waiting for ") + ReasonsText(waits);
    }
  }
  for (const auto& required : component.required) {
    item->Add(
        BuildRequired(connections, *item, {process, component.name, required.name}, required));
  }
  for (const auto& provided : component.provided) {
    item->Add(BuildProvided(connections, *item, {process, component.name, provided.name}, component,
                            provided));
  }
  return item;
}

std::unique_ptr<CatalogueItem> BuildProcess(const ConnectionIndex& connections,
                                            const ProcessEntry& entry) {
  const ProcessDescription& process = entry.process;
  Item item = MakeItem(ItemKind::kProcess, ToQString(process.name), ToQString(process.name));
  item->mark = MarkOf(process.state);
  item->state = ToQString(ToString(process.state));
  item->gone = IsGone(process.state);
  item->host = ToQString(process.host).toLower();
  item->since = process.since;
  item->detail = ToQString(process.reason);
  item->value =
      process.state == ProcessState::kAlive ? ToQString(process.host) : WordOf(process.state);
  for (const auto& [name, component] : entry.components) {
    item->Add(BuildComponent(connections, entry, component));
  }
  return item;
}

std::vector<std::unique_ptr<CatalogueItem>> BuildFieldItems(
    const CatalogueItem& column, const std::vector<NumericField>& fields) {
  CatalogueItem root;
  root.path = column.path;
  root.gone = column.gone;
  for (std::size_t index = 0; index < fields.size(); ++index) {
    CatalogueItem* item = &root;
    for (const QString& segment : Segments(fields[index].path)) item = &Group(*item, segment);
    if (item == &root) return {};
    item->kind = ItemKind::kField;
    item->field = static_cast<int>(index);
    item->unit = ToQString(fields[index].unit);
  }
  LiftUnits(root);
  return std::move(root.children);
}

}  // namespace tendon::gui
