#include <gcm_console/output/dot.h>

#include <gcm_console/output/table.h>

#include <locale>
#include <map>
#include <ostream>
#include <sstream>
#include <string>

namespace console {
namespace {

using tendon::graph::Rect;

std::string DotText(const std::string& text) { return "\"" + Plain(text) + "\""; }

/// Returns the name of the node of a component.
std::string NodeOf(const tendon::InterfaceName& end) {
  return DotText(end.process + "/" + end.component);
}

/// Converts positions for Graphviz: to points, with y measured upwards from the bottom.
class Arrangement {
 public:
  Arrangement() = default;
  explicit Arrangement(const Diagram& diagram) : height_(diagram.size.height) {
    for (const DiagramProcess& process : diagram.processes)
      rects_.emplace(process.name, process.rect);
    for (const DiagramNode& node : diagram.nodes) rects_.emplace(node.path, node.rect);
  }

  /// Returns the attributes of the graph. If all nodes have positions, Graphviz must only draw the
  /// arrows.
  [[nodiscard]] std::string OfGraph() const {
    return rects_.empty() ? "" : "  layout=nop;\n  splines=true;\n";
  }
  [[nodiscard]] std::string OfProcess(const std::string& name) const {
    const auto found = rects_.find(name);
    if (found == rects_.end()) return "";
    const Rect& rect = found->second;
    return "    bb=\"" + Text(rect.x) + "," + Text(height_ - rect.y - rect.height) + "," +
           Text(rect.x + rect.width) + "," + Text(height_ - rect.y) + "\";\n";
  }
  [[nodiscard]] std::string OfNode(const std::string& path) const {
    constexpr double kInch = 72;
    const auto found = rects_.find(path);
    if (found == rects_.end()) return "";
    const Rect& rect = found->second;
    return ", fixedsize=true, width=" + Text(rect.width / kInch) +
           ", height=" + Text(rect.height / kInch) + ", pos=\"" + Text(rect.x + rect.width / 2) +
           "," + Text(height_ - rect.y - rect.height / 2) + "\"";
  }

 private:
  /// Formats a number with a decimal point in every locale.
  static std::string Text(double number) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::fixed << number;
    return text.str();
  }

  double height_ = 0;
  std::map<std::string, Rect> rects_;
};

void Print(const tendon::Catalogue& catalogue, const Arrangement& arrangement, std::ostream& out) {
  out << "digraph system {\n  rankdir=LR;\n  node [shape=box];\n" << arrangement.OfGraph();
  for (const auto& [name, entry] : catalogue.processes()) {
    out << "  subgraph " << DotText("cluster_" + name) << " {\n    label=" << DotText(name) << ";\n"
        << arrangement.OfProcess(name);
    for (const auto& [component, description] : entry.components) {
      out << "    " << NodeOf({name, component, ""}) << " [label=" << DotText(component)
          << arrangement.OfNode(name + "/" + component) << "];\n";
    }
    out << "  }\n";
  }
  for (const auto& connection : catalogue.connections()) {
    const bool is_active = connection.state == tendon::ConnectionState::kActive;
    out << "  " << NodeOf(connection.required) << " -> " << NodeOf(connection.provided)
        << " [label="
        << DotText(connection.required.interface + " -> " + connection.provided.interface)
        << (is_active ? "" : ", style=dashed") << "];\n";
  }
  out << "}\n";
}

}  // namespace

void PrintDot(const tendon::Catalogue& catalogue, std::ostream& out) { Print(catalogue, {}, out); }

void PrintDot(const tendon::Catalogue& catalogue, const Diagram& arranged, std::ostream& out) {
  Print(catalogue, Arrangement(arranged), out);
}

}  // namespace console
