#include <gcm_gui/plot/plot_layout.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/series/time_shift.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <chrono>
#include <cstdint>
#include <vector>

namespace tendon::gui {
namespace {

using std::chrono::nanoseconds;

constexpr int kVersion = 1;
constexpr double kNsPerSecond = 1e9;

struct CurveLayout {
  CurveKey key;
  std::int64_t shift_ns = 0;
  bool is_hidden = false;
  CurveLook look;
};

struct PlotLayout {
  nanoseconds window = std::chrono::seconds(30);
  QString name;  // name of the page
  bool is_below = false;
  bool is_sweeping = false;
  bool is_logarithmic = false;
  std::vector<CurveLayout> curves;
};

// Returns the JSON of a plot, without the values that are the default.
QJsonObject JsonOf(const PlotView& view, const QString& name, bool is_below) {
  QJsonArray curves;
  for (const auto& curve : view.curves().curves()) {
    QJsonObject one{{"path", SignalOf(curve->path())}, {"unit", curve->unit()}};
    if (curve->isRecorded()) {
      one["recording"] = curve->recording();
      one["shift_ns"] = qint64{curve->shift()};
    }
    if (!curve->isVisible()) one["hidden"] = true;
    const auto& [scaling, axis] = curve->look();
    if (scaling.factor != 1) one["scale"] = scaling.factor;
    if (scaling.offset != 0) one["offset"] = scaling.offset;
    if (!axis.isEmpty()) one["axis"] = axis;
    curves.append(one);
  }
  const double seconds = static_cast<double>(view.timeWindow().length().count()) / kNsPerSecond;
  QJsonObject plot{{"window", seconds}, {"curves", curves}};
  if (!name.isEmpty() && !is_below) plot["name"] = name;
  if (is_below) plot["below"] = true;
  if (view.timeWindow().motion() == TimeWindow::Motion::kSweep) plot["sweep"] = true;
  if (view.curves().scale() == ValueScale::kLogarithmic) plot["logarithmic"] = true;
  return plot;
}

/// Returns the number; `usual` if it is missing; empty if it is not a number.
std::optional<double> NumberOr(const QJsonValue& json, double usual) {
  if (json.isUndefined()) return usual;
  return json.isDouble() ? std::optional(json.toDouble()) : std::nullopt;
}

/// Reads a curve. Returns the mistake in it, or an empty text.
QString ReadCurve(const QJsonValue& json, CurveLayout& curve) {
  curve.key = {json["path"].toString(), json["unit"].toString()};
  curve.is_hidden = json["hidden"].toBool();
  if (curve.key.path.isEmpty())
    return Words::tr("a curve has no path: give each curve a text \"path\"");
  if (json["recording"].isString()) {
    const QString recording = json["recording"].toString();
    constexpr qint64 kNoShift = kLongestShift + 1;
    curve.shift_ns = json["shift_ns"].toInteger(json["shift_ns"].isUndefined() ? 0 : kNoShift);
    if (recording.isEmpty() || curve.shift_ns > kLongestShift || curve.shift_ns < -kLongestShift) {
      return Words::tr(
                 "%1: \"recording\" must be a file, and \"shift_ns\" a whole number of ns up "
                 "to 100 years")
          .arg(curve.key.path);
    }
    curve.key.path = RecordedPath(recording, curve.key.path);
  }
  const auto factor = NumberOr(json["scale"], 1);
  const auto offset = NumberOr(json["offset"], 0);
  if (!factor || !offset) {
    return Words::tr("scale and offset of %1 must be numbers").arg(curve.key.path);
  }
  if (!json["axis"].isUndefined() && !json["axis"].isString()) {
    return Words::tr("\"axis\" of %1 must be text in quotes").arg(curve.key.path);
  }
  curve.look = {.scaling = {.factor = *factor, .offset = *offset}, .axis = json["axis"].toString()};
  const auto refusal = RefusalOf(curve.look);
  return refusal ? curve.key.path + QStringLiteral(": ") + *refusal : QString();
}

/// Reads a plot. Returns the mistake in it, or an empty text.
QString ReadPlot(const QJsonValue& json, PlotLayout& plot) {
  if (!json.isObject() || !json["curves"].isArray())
    return Words::tr("the list \"curves\" is missing");
  const double seconds = json["window"].toDouble();
  if (seconds <= 0 || seconds > TimeWindow::kLongest)
    return Words::tr("\"window\" must be above 0 and at most %1 s").arg(TimeWindow::kLongest);
  plot.window = nanoseconds(static_cast<std::int64_t>(seconds * kNsPerSecond));
  plot.name = json["name"].toString();
  plot.is_below = json["below"].toBool();
  plot.is_sweeping = json["sweep"].toBool();
  plot.is_logarithmic = json["logarithmic"].toBool();
  for (const QJsonValue& one : json["curves"].toArray()) {
    const QString wrong = ReadCurve(one, plot.curves.emplace_back());
    if (!wrong.isEmpty()) return wrong;
  }
  return {};
}

}  // namespace

QByteArray LayoutOf(const PlotPanel& panel) {
  QJsonArray plots;
  for (int i = 0; i < panel.plotCount(); ++i) {
    plots.append(JsonOf(panel.plot(i), panel.tabs().name(panel.plot(i)), panel.isBelow(i)));
  }
  QJsonObject layout{{"version", kVersion}, {"plots", plots}};
  if (!panel.areMarksShown()) layout["marks"] = false;
  return QJsonDocument(layout).toJson();
}

std::optional<QString> ShowLayout(PlotPanel& panel, const QByteArray& layout) {
  QJsonParseError error;
  const QJsonDocument document = QJsonDocument::fromJson(layout, &error);
  if (document.isNull()) return Words::tr("not JSON: %1").arg(error.errorString());
  const int version = document["version"].toInt();
  if (version != kVersion) {
    return Words::tr(
               "version %1 of plot layouts is not supported; this program supports version %2")
        .arg(version)
        .arg(kVersion);
  }
  std::vector<PlotLayout> plots;
  for (const QJsonValue& json : document["plots"].toArray()) {
    const QString wrong = ReadPlot(json, plots.emplace_back());
    if (!wrong.isEmpty()) return Words::tr("plot %1: ").arg(plots.size()) + wrong;
  }
  if (plots.empty()) return Words::tr("the file contains no plot: choose another file");
  while (panel.plotCount() > 1) panel.closePlot(0);
  panel.closePlot(0);
  for (std::size_t i = 0; i < plots.size(); ++i) {
    const PlotLayout& plot = plots[i];
    PlotView& view = i == 0 ? panel.plot(0) : plot.is_below ? panel.splitPlot() : panel.addPlot();
    view.setWindow(plot.window);
    using Motion = TimeWindow::Motion;
    view.setMotion(plot.is_sweeping ? Motion::kSweep : Motion::kScroll);
    view.setScale(plot.is_logarithmic ? ValueScale::kLogarithmic : ValueScale::kLinear);
    if (!plot.is_below) panel.tabs().setName(view, plot.name);
    for (const CurveLayout& curve : plot.curves) {
      const QString recording = RecordingOf(curve.key.path);
      if (!recording.isEmpty()) view.recordedCurves().setShift(recording, curve.shift_ns);
      panel.addSignal(curve.key.path, curve.key.unit);
      view.curve(curve.key.path)->setVisible(!curve.is_hidden);
      view.setLook(curve.key.path, curve.look);
    }
  }
  panel.setMarksShown(document["marks"].toBool(true));
  panel.showPlot(0);
  return std::nullopt;
}

}  // namespace tendon::gui
