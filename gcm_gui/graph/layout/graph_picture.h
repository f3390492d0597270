#pragma once

#include <tendon/gcm/catalog.h>
#include <tendon/manager/unmet_need.h>

#include <QSizeF>
#include <QString>
#include <cstdint>
#include <tuple>
#include <vector>

namespace tendon::gui {

enum class Side { kRequired, kProvided };

/// One end of an interface, or of a connection.
struct PortName {
  Side side = Side::kRequired;
  InterfaceName name;

  auto operator<=>(const PortName&) const = default;
};

struct PortPicture {
  PortName port;
  bool connected = false;

  bool operator==(const PortPicture&) const = default;
};

struct NodePicture {
  QString path;
  QString name;
  ComponentState state = ComponentState::kConstructed;
  std::vector<UnmetNeed> waits{};  ///< what keeps it from its work, though it runs
  std::vector<PortPicture> required;
  std::vector<PortPicture> provided;
  QSizeF size;  ///< what it needs, with the theme's fonts

  bool operator==(const NodePicture&) const = default;
};

struct ProcessPicture {
  QString name;
  ProcessState state = ProcessState::kAlive;
  std::int64_t since = 0;
  std::vector<NodePicture> nodes;
  double title_width = 0;  ///< what its title needs, with the theme's fonts
};

/// Data can run from a provided interface of one component to a required one of the other.
struct Affinity {
  QString provider;  ///< paths of components
  QString client;

  bool operator==(const Affinity&) const = default;
  bool operator<(const Affinity& other) const {
    return std::tie(provider, client) < std::tie(other.provider, other.client);
  }
};

/// What the graph shows of a catalogue, before anything is placed.
struct GraphPicture {
  std::vector<ProcessPicture> processes;
  std::vector<ConnectionDescription> edges;
  /// Of what is connected and of what could be, so that connecting moves nothing. Sorted.
  std::vector<Affinity> affinities;
};

}  // namespace tendon::gui
