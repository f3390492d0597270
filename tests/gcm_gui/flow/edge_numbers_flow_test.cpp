#include <gcm_gui/plot/canvas/axis_labels.h>
#include <gcm_gui/plot/controls/legend.h>
#include <gcm_gui/plot/plot_files.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gtest/gtest.h>
#include <qwt_scale_draw.h>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <functional>
#include <stdexcept>

#include "flow/flow_fixture.h"
#include "support/pictures.h"

namespace tendon::gui {
namespace {

const QString kNumbers = QStringLiteral("edges/fast/state.Numbers");
const QString kStates = QStringLiteral("edges/slow/state.States");

QByteArray SystemOfEdges() {
  const auto component = [](const char* name, const char* type) {
    return QJsonObject{{"name", name}, {"class", type}, {"library", "edge_numbers"}};
  };
  const QJsonObject process{{"name", "edges"},
                            {"components", QJsonArray{component("fast", "FastNumbers"),
                                                      component("slow", "SlowStates")}}};
  return QJsonDocument(
             QJsonObject{{"version", 1}, {"name", "edges"}, {"processes", QJsonArray{process}}})
      .toJson();
}

QByteArray LayoutOfEdges() {
  QJsonArray plots;
  const auto add = [&](const QString& path, const char* unit) {
    const QJsonObject curve{{"path", path}, {"unit", unit}};
    plots.append(
        QJsonObject{{"window", 5}, {"below", !plots.isEmpty()}, {"curves", QJsonArray{curve}}});
  };
  add(kNumbers + ".largest", "rad");
  add(kNumbers + ".turning", "V");
  add(kNumbers + ".smallest", "A");
  add(kNumbers + ".counter", "");
  add(kNumbers + ".stamp", "ns");
  add(kNumbers + ".unix_time", "s");
  add(kStates + ".mode", "");
  add(kStates + ".is_ready", "");
  return QJsonDocument(QJsonObject{{"version", 1}, {"plots", plots}}).toJson();
}

class EdgeNumbersFlow : public FlowFixture {
 protected:
  [[nodiscard]] QString Write(const char* name, const QByteArray& content) const {
    QFile file(QString::fromStdString((home_.path() / name).string()));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
    return file.fileName();
  }
  [[nodiscard]] PlotView& Plot(const QString& path) const {
    PlotPanel& panel = window_->plots();
    for (int index = 0; index < panel.plotCount(); ++index) {
      if (panel.plot(index).curve(path) != nullptr) return panel.plot(index);
    }
    throw std::runtime_error("no plot shows " + path.toStdString());
  }
  [[nodiscard]] QString ValueOf(const QString& path) const {
    const auto& rows = Plot(path).legendBox().rows();
    return rows.empty() ? QString() : rows.front()->entry().value;
  }
  /// Waits until the legend shows a value for which `is_right` is true.
  void ExpectValue(const QString& path, const std::function<bool(const QString&)>& is_right) {
    EXPECT_TRUE(Eventually([&] { return is_right(ValueOf(path)); }))
        << path.toStdString() << " is " << ValueOf(path).toStdString();
  }
};

TEST_F(EdgeNumbersFlow, AWindowPlotsExtremeNumbersCorrectly) {
  const QString system = Write("edges.json", SystemOfEdges());
  const auto edges = StartLcm("edges", system.toStdString());
  window_->resize(1280, 1400);
  window_->plots().files().openLayout(Write("edges.plots.json", LayoutOfEdges()));
  ASSERT_TRUE(Eventually([this] { return window_->plots().plotCount() == 8; }));

  const auto have_come = [this] {
    const PlotPanel& panel = window_->plots();
    for (int i = 0; i < panel.plotCount(); ++i) {
      const auto& curves = panel.plot(i).curves().curves();
      if (curves.empty() || curves.front()->samples().endIndex() <= 10) return false;
    }
    return true;
  };
  ASSERT_TRUE(Eventually(have_come)) << edges->err();

  const auto label = [this] {
    return Plot(kStates + ".mode").axisScaleDraw(QwtAxis::YLeft)->label(7).text();
  };
  EXPECT_TRUE(Eventually([&] { return label() == "automatic"; })) << label().toStdString();
  ExpectValue(kStates + ".mode", [](const QString& value) {
    return QStringList{"off", "manual", "automatic"}.contains(value);
  });
  ExpectValue(kStates + ".is_ready", [](const QString& value) {
    return QStringList{"false", "true"}.contains(value);
  });
  // These values are shown with all digits.
  ExpectValue(kNumbers + ".stamp", [](const QString& value) { return value.size() == 19; });
  ExpectValue(kNumbers + ".counter",
              [](const QString& value) { return value.startsWith("90000"); });
  for (int i = 0; i < window_->plots().plotCount(); ++i) {
    const auto& axes = window_->plots().plot(i).curves().axes();
    ASSERT_FALSE(axes.empty()) << i;
    EXPECT_TRUE(IsShowable(axes.front().range)) << i;
  }
  KeepPictures(*window_, "flow-edge-numbers");
}

}  // namespace
}  // namespace tendon::gui
