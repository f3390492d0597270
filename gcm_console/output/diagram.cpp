#include <gcm_console/output/diagram.h>

#include <gcm_console/catalogue/telemetry_column.h>
#include <tendon/base/text.h>
#include <tendon/gcm/lookup.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

namespace console {
namespace {

using tendon::Catalogue;
using tendon::ConnectionState;
using tendon::InterfaceName;
using tendon::graph::ColumnLayout;
using tendon::graph::LayerEdge;
using tendon::graph::Rect;
using tendon::graph::Size;

Condition ConditionOf(const tendon::ComponentDescription& component) {
  if (component.state == tendon::ComponentState::kFaulted) return Condition::kBad;
  if (!component.warning.empty()) return Condition::kWarning;
  return component.state == tendon::ComponentState::kActive ? Condition::kGood
                                                            : Condition::kResting;
}

Condition ConditionOf(tendon::ProcessState state) {
  if (state == tendon::ProcessState::kAlive) return Condition::kGood;
  if (state == tendon::ProcessState::kSuspect) return Condition::kWarning;
  return state == tendon::ProcessState::kLost ? Condition::kBad : Condition::kResting;
}

std::string PathOf(const InterfaceName& name) { return name.process + "/" + name.component; }

std::string TitleOf(const Catalogue& catalogue) {
  std::size_t components = 0;
  for (const auto& [name, entry] : catalogue.processes()) components += entry.components.size();
  return tendon::Counted(catalogue.processes().size(), "process", "processes") + ", " +
         tendon::Counted(components, "component", "components") + ", " +
         tendon::Counted(catalogue.connections().size(), "connection", "connections");
}

/// Collects the edges between blocks, without duplicates and without edges from a block to itself.
class Edges {
 public:
  explicit Edges(const std::vector<ColumnLayout::Block>& blocks) {
    for (std::size_t i = 0; i < blocks.size(); ++i) indices_[blocks[i].key] = i;
  }
  void Add(const std::string& provider, const std::string& client) {
    const auto from = indices_.find(provider);
    const auto to = indices_.find(client);
    if (from == indices_.end() || to == indices_.end() || from == to) return;
    edges_.emplace(from->second, to->second);
  }
  [[nodiscard]] std::vector<LayerEdge> Take() const {
    std::vector<LayerEdge> all;
    for (const auto& [from, to] : edges_) all.push_back({from, to});
    return all;
  }

 private:
  std::map<std::string, std::size_t> indices_;
  std::set<std::pair<std::size_t, std::size_t>> edges_;
};

/// Returns the width of the first two lines of a node.
double HeadWidth(const DiagramNode& node) {
  return std::max(TextWidth(node.name, diagram::kNameText),
                  diagram::kMark + TextWidth(node.detail, diagram::kSmallText)) +
         2 * diagram::kNodeInset;
}

double TitleWidth(const DiagramProcess& process) {
  return TextWidth(process.name, diagram::kNameText) + diagram::kGap +
         TextWidth(process.detail, diagram::kSmallText);
}

/// The factors by which existing positions must be stretched if objects need more room.
struct StretchFactors {
  double x = 1;
  double y = 1;

  void Fit(const Size& needed, const Size& shown) {
    if (shown.width > 0) x = std::max(x, needed.width / shown.width);
    if (shown.height > 0) y = std::max(y, needed.height / shown.height);
  }
  /// Stretches as far as `other`, but at most to kMax times the present factors.
  void FitMostly(const StretchFactors& other) {
    constexpr double kMax = 4;
    x = std::max(x, std::min(other.x, kMax * x));
    y = std::max(y, std::min(other.y, kMax * y));
  }
  [[nodiscard]] Rect operator()(const Rect& rect) const {
    return {rect.x * x, rect.y * y, rect.width * x, rect.height * y};
  }
};

std::string ProcessOf(const DiagramNode& node) { return node.path.substr(0, node.path.find('/')); }

class Placement {
 public:
  explicit Placement(const Catalogue& catalogue) : catalogue_(catalogue) {
    for (const auto& connection : catalogue.connections()) {
      connected_.insert(connection.required);
      connected_.insert(connection.provided);
    }
  }

  Diagram Take(const Places& shown) && {
    std::vector<ColumnLayout::Block> blocks;
    for (const auto& [name, entry] : catalogue_.processes()) AddProcess(name, entry, blocks);
    const Size all = IsAllIn(shown) ? PlaceAs(shown) : PlaceInColumns(std::move(blocks));
    for (const auto& one : catalogue_.connections()) AddWire(one);
    diagram_.title = TitleOf(catalogue_);
    const double width =
        std::max({all.width, TextWidth(diagram_.title, diagram::kTitleText), diagram::kMinWidth});
    diagram_.size = {width + 2 * diagram::kMargin, all.height + diagram::kTop + diagram::kBottom};
    return std::move(diagram_);
  }

 private:
  void AddProcess(const std::string& name, const tendon::ProcessEntry& entry,
                  std::vector<ColumnLayout::Block>& blocks) {
    DiagramProcess process{.name = name,
                           .detail = std::string(ToString(entry.process.state)),
                           .condition = ConditionOf(entry.process.state),
                           .rect = {}};
    if (!entry.process.host.empty()) process.detail += " on " + entry.process.host;
    std::vector<ColumnLayout::Block> inner;
    for (const auto& [component, description] : entry.components) {
      DiagramNode node = NodeOf(name, description);
      if (!IsPresent(entry.process)) {  // the last known state, which is now outdated
        node.detail.insert(0, "was ");
        node.condition = Condition::kResting;
        node.rect.width = std::max(node.rect.width, HeadWidth(node));
      }
      inner.push_back({node.path, {node.rect.width, node.rect.height}, true});
      diagram_.nodes.push_back(std::move(node));
    }
    Edges edges(inner);
    for (const auto& one : catalogue_.connections()) {
      edges.Add(PathOf(one.provided), PathOf(one.required));
    }
    const bool is_empty = inner.empty();
    ColumnLayout inside(
        ColumnLayout::Spacing{.columns = diagram::kBetweenNodes, .rows = diagram::kBelowNodes});
    inside.Arrange(std::move(inner), edges.Take());
    const Size size = {
        std::max(inside.size().width, TitleWidth(process)) + 2 * diagram::kProcessInset,
        inside.size().height + diagram::kProcessHead + diagram::kProcessInset};
    blocks.push_back({name, size, !is_empty});
    insides_.emplace(name, std::move(inside));
    diagram_.processes.push_back(std::move(process));
  }

  DiagramNode NodeOf(const std::string& process, const tendon::ComponentDescription& component) {
    DiagramNode node{.path = process + "/" + component.name,
                     .name = component.name,
                     .detail = std::string(ToString(component.state)),
                     .remark = component.fault.empty() ? component.warning : component.fault,
                     .condition = ConditionOf(component),
                     .rect = {},
                     .ports = {}};
    if (!component.class_name.empty()) node.detail += " · " + component.class_name;
    double left = 0;
    double right = 0;
    std::size_t required = 0;
    std::size_t provided = 0;
    const auto add = [&](const std::string& name, bool is_provided, std::size_t& row,
                         double& widest) {
      const bool is_connected = connected_.contains({process, component.name, name});
      if (is_provided && IsTable(name) && !is_connected) return;
      const double y =
          diagram::kNodeHead + (static_cast<double>(row++) + 0.5) * diagram::kPortPitch;
      node.ports.push_back({name, is_provided, is_connected, 0, y});
      widest = std::max(widest, TextWidth(name, diagram::kSmallText));
    };
    for (const auto& one : component.required) add(one.name, false, required, left);
    for (const auto& one : component.provided) add(one.name, true, provided, right);
    node.rect.width = std::max({diagram::kMinNode, HeadWidth(node),
                                left + right + diagram::kGap + 2 * diagram::kNodeInset});
    const auto rows = static_cast<double>(std::max(required, provided));
    node.rect.height = diagram::kNodeHead + rows * diagram::kPortPitch + diagram::kNodeTail;
    return node;
  }

  [[nodiscard]] bool IsAllIn(const Places& shown) const {
    return !shown.empty() && std::ranges::all_of(diagram_.processes, [&](const auto& process) {
      return shown.contains(process.name);
    }) && std::ranges::all_of(diagram_.nodes, [&](const auto& node) {
      return shown.contains(node.path);
    });
  }

  Size PlaceAs(const Places& shown) {
    StretchFactors stretch;
    StretchFactors insets;  // separate, because `shown` may have almost no insets
    Rect first{.x = HUGE_VAL, .y = HUGE_VAL};
    for (const DiagramProcess& process : diagram_.processes) {
      const Rect& box = shown.at(process.name);
      stretch.Fit({TitleWidth(process) + 2 * diagram::kProcessInset, diagram::kProcessHead},
                  {box.width, box.height});
      first.x = std::min(first.x, box.x);
      first.y = std::min(first.y, box.y);
    }
    for (const DiagramNode& node : diagram_.nodes) {
      const Rect& box = shown.at(ProcessOf(node));
      const Rect& rect = shown.at(node.path);
      stretch.Fit({node.rect.width, node.rect.height}, {rect.width, rect.height});
      insets.Fit({diagram::kProcessInset, diagram::kProcessHead}, {rect.x - box.x, rect.y - box.y});
    }
    stretch.FitMostly(insets);
    Size all;
    const auto place_of = [&](Rect rect) {
      rect.x -= first.x;
      rect.y -= first.y;
      rect = stretch(rect);
      all.width = std::max(all.width, rect.x + rect.width);
      all.height = std::max(all.height, rect.y + rect.height);
      rect.x += diagram::kMargin;
      rect.y += diagram::kTop;
      return rect;
    };
    for (DiagramProcess& process : diagram_.processes)
      process.rect = place_of(shown.at(process.name));
    for (DiagramNode& node : diagram_.nodes) {
      const double height = node.rect.height;
      Rect rect = place_of(shown.at(node.path));
      rect.height = height;
      Place(node, rect);
    }
    return all;
  }

  Size PlaceInColumns(std::vector<ColumnLayout::Block> processes) {
    Edges edges(processes);
    for (const auto& one : catalogue_.connections()) {
      edges.Add(one.provided.process, one.required.process);
    }
    ColumnLayout outside(ColumnLayout::Spacing{.columns = diagram::kBetweenProcesses,
                                               .rows = diagram::kBelowProcesses});
    outside.Arrange(std::move(processes), edges.Take());
    for (DiagramProcess& process : diagram_.processes) {
      process.rect = outside.rect(process.name);
      process.rect.x += diagram::kMargin;
      process.rect.y += diagram::kTop;
      for (DiagramNode& node : diagram_.nodes) {
        if (ProcessOf(node) != process.name) continue;
        Rect rect = insides_.at(process.name).rect(node.path);
        rect.x += process.rect.x + diagram::kProcessInset;
        rect.y += process.rect.y + diagram::kProcessHead;
        Place(node, rect);
      }
    }
    return outside.size();
  }

  void Place(DiagramNode& node, const Rect& rect) {
    node.rect = rect;
    for (DiagramPort& port : node.ports) {
      port.x = rect.x + (port.is_provided ? rect.width : 0);
      port.y += rect.y;
      ends_[{node.path, port.name, port.is_provided}] = {port.x, port.y};
    }
  }

  void AddWire(const tendon::ConnectionDescription& connection) {
    const auto from =
        ends_.find({PathOf(connection.provided), connection.provided.interface, true});
    const auto to = ends_.find({PathOf(connection.required), connection.required.interface, false});
    const std::string title =
        ToString(connection.required) + " -> " + ToString(connection.provided);
    if (from == ends_.end() || to == ends_.end()) return;
    diagram_.wires.push_back({.title = title,
                              .remark = connection.reason,
                              .state = connection.state,
                              .from_x = from->second.first,
                              .from_y = from->second.second,
                              .to_x = to->second.first,
                              .to_y = to->second.second});
  }

  const Catalogue& catalogue_;
  std::set<InterfaceName> connected_;
  std::map<std::string, ColumnLayout> insides_;  // by process
  std::map<std::tuple<std::string, std::string, bool>, std::pair<double, double>> ends_;
  Diagram diagram_;
};

}  // namespace

Diagram DiagramOf(const Catalogue& catalogue) { return DiagramOf(catalogue, {}); }

Diagram DiagramOf(const Catalogue& catalogue, const Places& shown) {
  return Placement(catalogue).Take(shown);
}

double TextWidth(const std::string& text, double size) {
  constexpr double kNarrow = 0.32;
  constexpr double kUsual = 0.59;
  constexpr double kCapital = 0.72;
  constexpr double kWide = 0.92;
  double width = 0;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if ((byte & 0xc0U) == 0x80U) continue;  // only the first byte of a character counts
    const bool is_narrow = std::string_view("iljtfrI.,:;|'/-() ").find(letter) != std::string::npos;
    const bool is_wide = std::string_view("mwMW@%").find(letter) != std::string::npos;
    const bool is_capital = std::isupper(byte) != 0;
    width += size * (is_narrow ? kNarrow : is_wide ? kWide : is_capital ? kCapital : kUsual);
  }
  return width;
}

}  // namespace console
