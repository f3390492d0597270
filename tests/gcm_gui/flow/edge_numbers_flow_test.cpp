#include <gcm_gui/plot/canvas/axis_labels.h>
#include <gcm_gui/plot/legend/legend.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gtest/gtest.h>
#include <qwt_scale_draw.h>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

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
    int index = 0;
    while (panel.plot(index).curve(path) == nullptr) ++index;
    return panel.plot(index);
  }
  [[nodiscard]] QString ValueOf(const QString& path) const {
    return Plot(path).legendBox().rows().front()->entry().value;
  }
};

TEST_F(EdgeNumbersFlow, AWindowWithALayoutOfThemOpensAndTellsThemAsTheyAre) {
  const QString system = Write("edges.json", SystemOfEdges());
  const auto edges = StartLcm("edges", system.toStdString());
  window_->resize(1280, 1400);
  window_->plots().openLayout(Write("edges.plots.json", LayoutOfEdges()));
  ASSERT_TRUE(Eventually([this] { return window_->plots().plotCount() == 8; }));

  const auto have_come = [this] {
    const Curve* slow = Plot(kStates + ".mode").curve(kStates + ".mode");
    return slow->samples().endIndex() > 10;
  };
  ASSERT_TRUE(Eventually(have_come)) << edges->err();

  const PlotView& modes = Plot(kStates + ".mode");
  EXPECT_EQ(modes.axisScaleDraw(QwtAxis::YLeft)->label(7).text(), "automatic");
  EXPECT_TRUE((QStringList{"off", "manual", "automatic"}).contains(ValueOf(kStates + ".mode")));
  EXPECT_TRUE((QStringList{"false", "true"}).contains(ValueOf(kStates + ".is_ready")));
  EXPECT_EQ(ValueOf(kNumbers + ".stamp").size(), 19) << "with all its digits";
  EXPECT_TRUE(ValueOf(kNumbers + ".counter").startsWith("90000"));
  for (int i = 0; i < window_->plots().plotCount(); ++i) {
    const UnitAxis& axis = window_->plots().plot(i).curves().axes().front();
    EXPECT_TRUE(IsShowable(axis.range)) << i;
  }
  KeepPictures(*window_, "flow-edge-numbers");
}

}  // namespace
}  // namespace tendon::gui
