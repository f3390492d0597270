#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/column_layout.h>

#include <map>
#include <string>
#include <vector>

namespace console {

/// The condition of a thing, which a picture shows as a colour.
enum class Condition { kGood, kResting, kWarning, kBad };

/// An interface in the picture, on the border of its component.
struct SheetPort {
  std::string name;
  bool is_provided = false;  ///< provided interfaces are on the right, required ones on the left
  bool is_connected = false;
  double x = 0;
  double y = 0;
};

struct SheetNode {
  std::string path;
  std::string name;
  std::string detail;  ///< "active · SimulatedArm"
  std::string remark;  ///< its problem
  Condition condition = Condition::kGood;
  tendon::graph::Rect rect;
  std::vector<SheetPort> ports;
};

struct SheetProcess {
  std::string name;
  std::string detail;  ///< "alive on robot-pc"
  Condition condition = Condition::kGood;
  tendon::graph::Rect rect;
};

/// A line from the provided interface to the required one, as in the window.
struct SheetWire {
  std::string title;  ///< "desk/supervisor/Robot -> robot/arm/Control"
  std::string remark;
  tendon::ConnectionState state = tendon::ConnectionState::kActive;
  double from_x = 0;
  double from_y = 0;
  double to_x = 0;
  double to_y = 0;
};

/// The layout of a system's picture, in pixels.
struct Sheet {
  tendon::graph::Size size;
  std::string title;
  std::vector<SheetProcess> processes;
  std::vector<SheetNode> nodes;
  std::vector<SheetWire> wires;  ///< only connections with both ends in the picture
};

/// Lays out the system with providers to the left of their clients. Leaves out state tables without
/// connections.
[[nodiscard]] Sheet SheetOf(const tendon::Catalogue& catalogue);

/// Existing positions, for example of a window: by the path of a component and by the name of a
/// process, whose rectangle encloses its components. In any unit of length.
using Places = std::map<std::string, tendon::graph::Rect>;

/// Keeps the arrangement of `shown`, stretched as far as necessary. If `shown` lacks a thing, the
/// layout is that of SheetOf(catalogue).
[[nodiscard]] Sheet SheetOf(const tendon::Catalogue& catalogue, const Places& shown);

/// The width of a text of this size in a common font, an approximation, too small rather than too
/// large.
[[nodiscard]] double TextWidth(const std::string& text, double size);

}  // namespace console
