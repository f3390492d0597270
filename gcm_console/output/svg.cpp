#include <gcm_console/output/svg.h>

#include <gcm_console/output/table.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace console {
namespace {

using tendon::ConnectionState;
using tendon::graph::Rect;

// The colours of the window in the light theme.
constexpr const char* kGround = "#f4f6f8";
constexpr const char* kPanel = "#ffffff";
constexpr const char* kRaised = "#f8fafc";
constexpr const char* kLine = "#c9d0da";
constexpr const char* kText = "#1a2230";
constexpr const char* kDim = "#566273";
constexpr const char* kGoodColour = "#127a4b";
constexpr const char* kWarningColour = "#9a5b00";
constexpr const char* kBadColour = "#bf3430";

const char* ColourOf(Condition condition) {
  switch (condition) {
    case Condition::kGood:
      return kGoodColour;
    case Condition::kResting:
      return kDim;
    case Condition::kWarning:
      return kWarningColour;
    case Condition::kBad:
      return kBadColour;
  }
  return kDim;
}

const char* ColourOf(ConnectionState state) {
  if (state == ConnectionState::kActive) return kGoodColour;
  return state == ConnectionState::kPending ? kWarningColour : kBadColour;
}

const char* DashesOf(ConnectionState state) {
  if (state == ConnectionState::kActive) return "";
  return state == ConnectionState::kPending ? " stroke-dasharray=\"7 5\""
                                            : " stroke-dasharray=\"2 4\"";
}

/// Escapes a text so that it can be used between tags and in attributes.
std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char letter : Plain(text)) {
    if (letter == '&') {
      escaped += "&amp;";
    } else if (letter == '<') {
      escaped += "&lt;";
    } else if (letter == '>') {
      escaped += "&gt;";
    } else if (letter == '"') {
      escaped += "&quot;";
    } else {
      escaped += letter;
    }
  }
  return escaped;
}

struct TextLook {
  double size = diagram::kSmallText;
  const char* colour = kText;
  const char* more = "";  // attributes
};

void PrintText(std::ostream& out, double x, double y, const std::string& text,
               const TextLook& look) {
  out << "  <text x=\"" << x << "\" y=\"" << y << "\" font-size=\"" << look.size << "\" fill=\""
      << look.colour << '"' << look.more << '>' << Escaped(text) << "</text>\n";
}

void PrintBox(std::ostream& out, const Rect& rect, const char* fill, const char* stroke,
              double radius) {
  out << "  <rect x=\"" << rect.x << "\" y=\"" << rect.y << "\" width=\"" << rect.width
      << "\" height=\"" << rect.height << "\" rx=\"" << radius << "\" fill=\"" << fill
      << "\" stroke=\"" << stroke << "\"/>\n";
}

void Print(std::ostream& out, const DiagramProcess& process) {
  constexpr double kRadius = 10;
  constexpr double kBaseline = 26;
  PrintBox(out, process.rect, kPanel,
           process.condition == Condition::kGood ? kLine : ColourOf(process.condition), kRadius);
  const double x = process.rect.x + diagram::kProcessInset;
  const double y = process.rect.y + kBaseline;
  PrintText(out, x, y, process.name, {diagram::kNameText, kText, " font-weight=\"600\""});
  PrintText(out, process.rect.x + process.rect.width - diagram::kProcessInset, y, process.detail,
            {diagram::kSmallText, ColourOf(process.condition), " text-anchor=\"end\""});
}

void Print(std::ostream& out, const DiagramPort& port) {
  constexpr double kBaseline = 4;
  const double inset = port.is_provided ? -diagram::kNodeInset : diagram::kNodeInset;
  out << "  <circle cx=\"" << port.x << "\" cy=\"" << port.y << "\" r=\"" << diagram::kPortRadius
      << "\" fill=\"" << (port.is_connected ? kDim : kPanel) << "\" stroke=\"" << kDim
      << "\" stroke-width=\"1.5\"/>\n";
  PrintText(out, port.x + inset, port.y + kBaseline, port.name,
            {diagram::kSmallText, kText, port.is_provided ? " text-anchor=\"end\"" : ""});
}

void Print(std::ostream& out, const DiagramNode& node) {
  constexpr double kRadius = 6;
  constexpr double kName = 20;
  constexpr double kDetail = 38;
  constexpr double kMarkRadius = 4;
  const bool is_ill = node.condition == Condition::kBad || node.condition == Condition::kWarning;
  out << " <g>\n  <title>" << Escaped(node.path + (node.remark.empty() ? "" : ": " + node.remark))
      << "</title>\n";
  PrintBox(out, node.rect, kRaised, is_ill ? ColourOf(node.condition) : kLine, kRadius);
  const double x = node.rect.x + diagram::kNodeInset;
  PrintText(out, x, node.rect.y + kName, node.name,
            {diagram::kNameText, kText, " font-weight=\"600\""});
  out << "  <circle cx=\"" << x + kMarkRadius << "\" cy=\"" << node.rect.y + kDetail - kMarkRadius
      << "\" r=\"" << kMarkRadius << "\" fill=\"" << ColourOf(node.condition) << "\"/>\n";
  PrintText(out, x + diagram::kMark, node.rect.y + kDetail, node.detail,
            {diagram::kSmallText, kDim, ""});
  for (const DiagramPort& port : node.ports) Print(out, port);
  out << " </g>\n";
}

/// Draws a connection with the same bends as in the window. A line that goes to the left bends
/// more.
void Print(std::ostream& out, const DiagramWire& wire) {
  constexpr double kMinBend = 36;
  constexpr double kMaxBend = 160;
  const double distance = std::abs(wire.to_x - wire.from_x);
  const double wanted = wire.to_x > wire.from_x ? distance / 2 : distance / 3 + kMinBend;
  const double bend = std::clamp(wanted, kMinBend, kMaxBend);
  out << " <path d=\"M " << wire.from_x << ' ' << wire.from_y << " C " << wire.from_x + bend << ' '
      << wire.from_y << ' ' << wire.to_x - bend << ' ' << wire.to_y << ' ' << wire.to_x << ' '
      << wire.to_y << "\" fill=\"none\" stroke=\"" << ColourOf(wire.state)
      << "\" stroke-width=\"2\"" << DashesOf(wire.state) << "><title>"
      << Escaped(wire.title + " (" + std::string(ToString(wire.state)) + ")" +
                 (wire.remark.empty() ? "" : ": " + wire.remark))
      << "</title></path>\n";
}

/// Prints the legend with the kinds of lines.
void PrintLegend(std::ostream& out, double y) {
  constexpr double kSample = 32;
  constexpr double kToText = 8;
  constexpr double kBaseline = 4;
  double x = diagram::kMargin;
  for (const auto state :
       {ConnectionState::kActive, ConnectionState::kPending, ConnectionState::kFailed}) {
    out << "  <line x1=\"" << x << "\" y1=\"" << y << "\" x2=\"" << x + kSample << "\" y2=\"" << y
        << "\" stroke=\"" << ColourOf(state) << "\" stroke-width=\"2\"" << DashesOf(state)
        << "/>\n";
    const std::string name(ToString(state));
    PrintText(out, x + kSample + kToText, y + kBaseline, name, {diagram::kSmallText, kDim, ""});
    x += kSample + kToText + TextWidth(name, diagram::kSmallText) + diagram::kGap;
  }
}

}  // namespace

void PrintSvg(const Diagram& diagram, std::ostream& out) {
  constexpr double kTitleLine = 40;
  constexpr double kLegendLine = 28;  // distance from the lower edge
  const double width = std::ceil(diagram.size.width);
  const double height = std::ceil(diagram.size.height);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
      << "\" viewBox=\"0 0 " << width << ' ' << height
      << "\" font-family=\"Inter, Helvetica, Arial, sans-serif\">\n"
      << " <rect width=\"" << width << "\" height=\"" << height << "\" fill=\"" << kGround
      << "\"/>\n";
  PrintText(out, diagram::kMargin, kTitleLine, diagram.title,
            {diagram::kTitleText, kText, " font-weight=\"600\""});
  for (const DiagramProcess& process : diagram.processes) Print(out, process);
  for (const DiagramWire& wire : diagram.wires) Print(out, wire);
  for (const DiagramNode& node : diagram.nodes) Print(out, node);
  PrintLegend(out, height - kLegendLine);
  out << "</svg>\n";
}

}  // namespace console
