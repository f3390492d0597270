#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/column_layout.h>

#include <map>
#include <string>
#include <vector>

namespace console {

/// The condition of an object. The picture shows it by a colour.
enum class Condition { kGood, kResting, kWarning, kBad };

/// An interface in the picture, on the border of its component.
struct DiagramPort {
  std::string name;
  bool is_provided = false;  ///< provided interfaces are on the right, required ones on the left
  bool is_connected = false;
  double x = 0;
  double y = 0;
};

struct DiagramNode {
  std::string path;
  std::string name;
  std::string detail;  ///< state and class: "active · SimulatedArm"
  std::string remark;  ///< the problem of the component
  Condition condition = Condition::kGood;
  tendon::graph::Rect rect;
  std::vector<DiagramPort> ports;
};

struct DiagramProcess {
  std::string name;
  std::string detail;  ///< state and host: "alive on robot-pc"
  Condition condition = Condition::kGood;
  tendon::graph::Rect rect;
};

/// A line from the provided interface to the required one, as in the window.
struct DiagramWire {
  std::string title;  ///< "desk/supervisor/Robot -> robot/arm/Control"
  std::string remark;
  tendon::ConnectionState state = tendon::ConnectionState::kActive;
  double from_x = 0;
  double from_y = 0;
  double to_x = 0;
  double to_y = 0;
};

/// The layout of a system's picture, in pixels.
struct Diagram {
  tendon::graph::Size size;
  std::string title;
  std::vector<DiagramProcess> processes;
  std::vector<DiagramNode> nodes;
  std::vector<DiagramWire> wires;  ///< only connections whose interfaces are both in the picture
};

/// Lays out the system. Providers are to the left of their clients. State tables without
/// connections are left out.
[[nodiscard]] Diagram DiagramOf(const tendon::Catalogue& catalogue);

/// Existing positions, for example those in a window: by path for a component, by name for a
/// process. The rectangle of a process encloses its components. The unit of length does not matter.
using Places = std::map<std::string, tendon::graph::Rect>;

/// Lays out the system as in `shown`, stretched as far as necessary. If an object is missing in
/// `shown`, the layout is the same as in DiagramOf(catalogue).
[[nodiscard]] Diagram DiagramOf(const tendon::Catalogue& catalogue, const Places& shown);

/// Returns the approximate width of a text of this size in a common font. The result may be too
/// small rather than too large.
[[nodiscard]] double TextWidth(const std::string& text, double size);

}  // namespace console

/// Sizes and distances in the drawn system, in pixels.
namespace console::diagram {

inline constexpr double kMargin = 24;
inline constexpr double kMinWidth = 360;  ///< minimum width between the margins
inline constexpr double kTop = 64;        ///< height for the title
inline constexpr double kBottom = 64;     ///< height for the legend
inline constexpr double kBetweenProcesses = 96;
inline constexpr double kBelowProcesses = 28;
inline constexpr double kBetweenNodes = 80;
inline constexpr double kBelowNodes = 20;
inline constexpr double kProcessHead = 40;
inline constexpr double kProcessInset = 20;
inline constexpr double kNodeHead = 48;  ///< from a node's top to its ports
inline constexpr double kNodeTail = 8;
inline constexpr double kNodeInset = 14;
inline constexpr double kMinNode = 128;
inline constexpr double kPortPitch = 22;
inline constexpr double kPortRadius = 4.5;
inline constexpr double kGap = 28;   ///< between two texts
inline constexpr double kMark = 14;  ///< width for a mark before a text
inline constexpr double kTitleText = 16;
inline constexpr double kNameText = 14;
inline constexpr double kSmallText = 12;

}  // namespace console::diagram
