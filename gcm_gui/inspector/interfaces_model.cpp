#include <gcm_gui/inspector/interfaces_model.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/connection_index.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/models/table_columns.h>
#include <gcm_gui/models/text.h>

#include <algorithm>
#include <utility>

namespace tendon::gui {
namespace {

using RowKind = InterfaceRow::Kind;

class RowBuilder {
 public:
  RowBuilder(const Catalogue& catalogue, const std::string& process,
             const ComponentDescription& component)
      : catalogue_(catalogue), connections_(catalogue), process_(process), component_(component) {}

  std::vector<InterfaceRow> Build() && {
    for (const auto& required : component_.required) AddRequired(required);
    for (const auto& provided : component_.provided) AddProvided(provided);
    return std::move(rows_);
  }

 private:
  void AddRequired(const RequiredDescription& required) {
    const InterfaceName name{process_, component_.name, required.name};
    const auto* connection = connections_.Of(name);
    const StateMark mark = MarkOf(connection);
    Add({RowKind::kRequired,
         PathOf(name),
         ToQString(required.name),
         QStringLiteral("required"),
         WordOf(mark),
         mark,
         {}});
    if (connection != nullptr) {
      AddPeer(QStringLiteral("← "), connection->provided, name, mark);
    }
    AddMembers(name, RowKind::kMember, required.functions);
    AddMembers(name, RowKind::kEvent, required.event_handlers);
  }

  void AddProvided(const ProvidedDescription& provided) {
    const InterfaceName name{process_, component_.name, provided.name};
    Add({RowKind::kProvided,
         PathOf(name),
         ToQString(provided.name),
         QStringLiteral("provided"),
         CountText(connections_.Clients(name), Words::tr("%1 client"), Words::tr("%1 clients")),
         StateMark::kConnected,
         {}});
    AddClients(name);
    const auto table = std::find_if(component_.tables.begin(), component_.tables.end(),
                                    [&](const auto& t) { return t.name == provided.name; });
    if (table == component_.tables.end()) {
      AddMembers(name, RowKind::kMember, provided.commands);
    } else {
      for (const auto* column : ColumnsOf(*table)) {
        Add({RowKind::kColumn,
             PathOf(name) + '.' + ToQString(column->name),
             ToQString(column->name),
             ToQString(column->type).section('.', -1),
             {},
             {},
             {}});
      }
    }
    AddMembers(name, RowKind::kEvent, provided.events);
  }

  void AddClients(const InterfaceName& provided) {
    for (const auto& [process, entry] : catalogue_.processes()) {
      for (const auto& [id, connection] : entry.connections) {
        if (connection.provided != provided) continue;
        AddPeer(QStringLiteral("→ "), connection.required, connection.required,
                MarkOf(connection.state));
      }
    }
  }

  void AddMembers(const InterfaceName& interface, RowKind kind,
                  const std::vector<MemberDescription>& members) {
    for (const auto& member : members) {
      const QString value =
          kind == RowKind::kEvent ? QString() : ToQString(ToString(member.signature.kind));
      Add({kind,
           PathOf(interface) + '.' + ToQString(member.name),
           ToQString(member.name),
           TypesText(member, TypeNames::kShort),
           value,
           {},
           {},
           ExpiryText(member)});
    }
  }

  /// Adds a row such as "teleoperation/Robot". The process is shown after the name; the tool tip is
  /// the path.
  void AddPeer(const QString& arrow, const InterfaceName& peer, const InterfaceName& required,
               StateMark mark) {
    const QString name = ToQString(peer.component + '/' + peer.interface);
    const QString process = peer.process == process_ ? QString() : ToQString(peer.process);
    Add({RowKind::kPeer, PathOf(peer), arrow + name, process, {}, mark, required});
  }

  static QString PathOf(const InterfaceName& name) { return ToQString(tendon::ToString(name)); }
  void Add(InterfaceRow row) { rows_.push_back(std::move(row)); }

  const Catalogue& catalogue_;
  ConnectionIndex connections_;
  const std::string& process_;
  const ComponentDescription& component_;
  std::vector<InterfaceRow> rows_;
};

QVariant NameData(const InterfaceRow& row, int role) {
  const bool interface = row.kind == RowKind::kRequired || row.kind == RowKind::kProvided;
  switch (role) {
    case Qt::DisplayRole:
      return row.name;
    case kFontStyleRole:
      if (row.kind == RowKind::kPeer) return static_cast<int>(FontStyle::kMono);
      return static_cast<int>(interface ? FontStyle::kStrong : FontStyle::kPlain);
    case kGlyphMarkRole:
      return interface ? QVariant::fromValue(row.mark) : QVariant();
    case kGlyphRole:
      if (row.kind == RowKind::kMember) return QStringLiteral("ƒ");
      if (row.kind == RowKind::kEvent) return QStringLiteral("⚡");
      return row.kind == RowKind::kColumn ? QStringLiteral("~") : QStringLiteral(" ");
    case kDetailRole:
      return row.types;
    default:
      return {};
  }
}

}  // namespace

QVariant InterfacesModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const InterfaceRow& row = this->row(index.row());
  const bool is_interface = row.kind == RowKind::kRequired || row.kind == RowKind::kProvided;
  const InterfaceHealth health = is_interface ? health_.value(row.path) : InterfaceHealth();
  switch (role) {
    case kPathRole:
      return row.path;
    case Qt::ToolTipRole: {
      QStringList lines{row.path, row.types, row.expiry, health.whole};
      lines.removeAll({});
      return lines.join('\n');
    }
    case Qt::AccessibleTextRole:
      return QStringList{row.name, row.types, row.value, row.expiry}.join(' ').simplified();
    case kTrailRole:
      return health.brief.isEmpty() ? row.value : row.value + QStringLiteral(" · ") + health.brief;
    default:
      return NameData(row, role);
  }
}

void InterfacesModel::show(const Catalogue& catalogue, const std::string& process,
                           const std::string& component) {
  std::vector<InterfaceRow> fresh;
  if (const auto* description = catalogue.FindComponent(process, component)) {
    fresh = RowBuilder(catalogue, process, *description).Build();
  }
  showRows(std::move(fresh));
}

int InterfacesModel::rowOf(const QString& path) const {
  for (int i = 0; i < rowCount(); ++i) {
    if (row(i).kind != RowKind::kPeer && row(i).path == path) return i;
  }
  return -1;
}

void InterfacesModel::showHealth(const QHash<QString, InterfaceHealth>& health) {
  if (health == health_) return;
  health_ = health;
  if (rowCount() > 0) Q_EMIT dataChanged(index(0), index(rowCount() - 1));
}

}  // namespace tendon::gui
