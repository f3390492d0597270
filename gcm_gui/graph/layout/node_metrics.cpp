#include <gcm_gui/graph/layout/node_metrics.h>

#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr double kMinWidth = 104;
constexpr double kTitleSlack = 96;  // room for " · lost 12 min"

double WidestName(const std::vector<PortPicture>& ports, const QFontMetricsF& metrics) {
  double widest = 0;
  for (const auto& port : ports) {
    widest = std::max(widest, metrics.horizontalAdvance(ToQString(port.port.name.interface)));
  }
  return widest;
}

}  // namespace

QSizeF SizeOf(const NodePicture& node) {
  const QFontMetricsF text(Theme::instance().text());
  const QFontMetricsF strong(Theme::instance().strong());
  const double left = WidestName(node.required, text);
  const double right = WidestName(node.provided, text);
  const double between = left > 0 && right > 0 ? 2 * kNodeInset : 0;
  const double content = std::max(strong.horizontalAdvance(node.name) + 2 * kNodeInset,
                                  left + between + right + 2 * kPortInset);
  const double width = std::max(kMinWidth, content + kGrid);
  const auto rows = static_cast<double>(std::max(node.required.size(), node.provided.size()));
  return {std::ceil(width / kGrid) * kGrid, kNodeHead + rows * kPortPitch + kNodeTail};
}

double WidthOfTitle(const QString& process) {
  return QFontMetricsF(Theme::instance().strong()).horizontalAdvance(process) + kTitleSlack;
}

QPointF PortCentre(const QRectF& node, Side side, int index) {
  return {side == Side::kRequired ? node.left() : node.right(),
          node.top() + kNodeHead + (index + 0.5) * kPortPitch};
}

}  // namespace tendon::gui
