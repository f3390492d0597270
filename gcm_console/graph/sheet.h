#pragma once

#include <tendon/gcm/catalog.h>
#include <tendon/gcm/graph/column_layout.h>

#include <map>
#include <string>
#include <vector>

namespace console {

/// How something is doing, which a picture tells by colour.
enum class Condition { kGood, kResting, kWarning, kBad };

/// Where an interface is shown: on the border of its component.
struct SheetPort {
  std::string name;
  bool is_provided = false;  ///< at the right; what is required is at the left
  bool is_connected = false;
  double x = 0;
  double y = 0;
};

struct SheetNode {
  std::string path;
  std::string name;
  std::string detail;  ///< "active · SimulatedArm"
  std::string remark;  ///< what is wrong with it
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

/// From the provided interface to the required one, the way that the window draws it.
struct SheetWire {
  std::string title;  ///< "desk/supervisor/Robot -> robot/arm/Control"
  std::string remark;
  tendon::ConnectionState state = tendon::ConnectionState::kActive;
  double from_x = 0;
  double from_y = 0;
  double to_x = 0;
  double to_y = 0;
};

/// A picture of a system before it is drawn: what stands where, in pixels.
struct Sheet {
  tendon::graph::Size size;
  std::string title;
  std::vector<SheetProcess> processes;
  std::vector<SheetNode> nodes;
  std::vector<SheetWire> wires;  ///< of those connections whose ends are both there
};

/// Providers stand left of their clients. State tables are left out, unless something is connected
/// to them.
[[nodiscard]] Sheet SheetOf(const tendon::Catalog& catalog);

/// Where things are shown elsewhere: by the path of a component, and by the name of a process,
/// whose rectangle is around its components. In any measure.
using Places = std::map<std::string, tendon::graph::Rect>;

/// Everything stands to everything else as in `shown`, which is stretched as far as it takes. As
/// without it where anything is missing there.
[[nodiscard]] Sheet SheetOf(const tendon::Catalog& catalog, const Places& shown);

/// How wide a text of that size is in a usual font, or a little less.
[[nodiscard]] double TextWidth(const std::string& text, double size);

}  // namespace console
