#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/manager/unsatisfied_interface.h>

#include <QSizeF>
#include <QString>
#include <cstdint>
#include <tuple>
#include <vector>

namespace tendon::gui {

enum class Side { kRequired, kProvided };

/// The name of an interface, and whether it is required or provided.
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
  /// The connections for which a running component still waits.
  std::vector<UnsatisfiedInterface> waits{};
  std::vector<PortPicture> required;
  std::vector<PortPicture> provided;
  QSizeF size;  ///< the size that the node needs in the theme's fonts

  bool operator==(const NodePicture&) const = default;
};

struct ProcessPicture {
  QString name;
  ProcessState state = ProcessState::kAlive;
  std::int64_t since = 0;
  std::vector<NodePicture> nodes;
  double title_width = 0;  ///< the width that the title needs in the theme's fonts
};

/// A possible connection between two components: the provided interface belongs to one, the
/// required interface to the other.
struct Affinity {
  QString provider;  ///< both are paths of components
  QString client;

  bool operator==(const Affinity&) const = default;
  bool operator<(const Affinity& other) const {
    return std::tie(provider, client) < std::tie(other.provider, other.client);
  }
};

/// The contents of the graph before positions are computed.
struct GraphPicture {
  std::vector<ProcessPicture> processes;
  std::vector<ConnectionDescription> edges;
  /// The affinities of existing and possible connections, sorted. Possible ones are included so
  /// that making a connection does not move items.
  std::vector<Affinity> affinities;
};

}  // namespace tendon::gui
