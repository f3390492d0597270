// Compares a frame of the window's plots with a frame of plain Qwt plots, which use their
// aggressive filter, on the same data. Both draw the whole canvas with axes and grid, and all axes
// move.

#include <benchmarks/measurement.h>
#include <gcm_gui/benchmarks/canvas_application.h>
#include <gcm_gui/plot/plot_view.h>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>

#include <QPixmap>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace tendon::benchmark {
namespace {

using gui::PlotView;
using gui::Sample;

constexpr int kRate = 1000;  // Hz

enum class Signal { kSmooth, kNoise };

// Columns by which the plot moves from frame to frame. A live plot moves by whole columns and
// reuses the previous frame. Otherwise the whole frame is drawn again.
constexpr double kLive = 1;
constexpr double kAnew = 1.377;

struct Scenery {
  Signal signal = Signal::kSmooth;
  int plots = 1;
  int curves = 1;
  QSize size;
  double columns = kLive;
  int seconds = 60;

  [[nodiscard]] std::size_t rows() const { return static_cast<std::size_t>(seconds * kRate); }
};

std::vector<double> ValuesOf(const Scenery& scenery, int curve) {
  constexpr double kNoise = 0.01;
  constexpr double kPeriods = 3;
  constexpr double kShift = 0.1;
  std::mt19937 random(static_cast<unsigned>(curve));
  std::normal_distribution<double> gauss;
  std::vector<double> values(scenery.rows());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(values.size());
    const double phase = 2 * std::numbers::pi * (part * kPeriods + curve * kShift);
    const bool is_smooth = scenery.signal == Signal::kSmooth;
    values[i] = is_smooth ? std::sin(phase) + kNoise * gauss(random) : gauss(random);
  }
  return values;
}

class Ours {
 public:
  explicit Ours(const Scenery& scenery) : columns_(scenery.columns) {
    for (int plot = 0; plot < scenery.plots; ++plot) {
      auto view = std::make_unique<PlotView>();
      view->resize(scenery.size);
      view->setWindow(std::chrono::seconds(scenery.seconds));
      for (int i = 0; i < scenery.curves; ++i) {
        const std::vector<double> values = ValuesOf(scenery, i);
        std::vector<Sample> rows;
        for (std::size_t row = 0; row < values.size(); ++row) {
          rows.push_back({.time_ns = static_cast<std::int64_t>(row) * 1'000'000,
                          .tick = row,
                          .value = values[row]});
        }
        view->addCurve({QString("p/c%1/state.x").arg(i), "rad"}).append(rows);
      }
      view->ensurePolished();
      view->refresh();
      view->grab();
      views_.push_back(std::move(view));
    }
  }

  void Draw(QPixmap& target) {
    for (auto& view : views_) {
      view->gestures().panTime(columns_);
      view->refresh();
      view->render(&target);
    }
  }

 private:
  std::vector<std::unique_ptr<PlotView>> views_;
  double columns_;
};

class Stock {
 public:
  explicit Stock(const Scenery& scenery) : seconds_(scenery.seconds) {
    for (int plot = 0; plot < scenery.plots; ++plot) {
      auto view = std::make_unique<QwtPlot>();
      view->resize(scenery.size);
      (new QwtPlotGrid)->attach(view.get());
      std::vector<double> times(scenery.rows());
      for (std::size_t i = 0; i < times.size(); ++i) times[i] = static_cast<double>(i) / kRate;
      for (int i = 0; i < scenery.curves; ++i) {
        auto* curve = new QwtPlotCurve;
        curve->setSamples(times.data(), ValuesOf(scenery, i).data(),
                          static_cast<int>(times.size()));
        curve->setPaintAttribute(QwtPlotCurve::FilterPointsAggressive);
        curve->setPen(Qt::blue, 1);
        curve->attach(view.get());
      }
      view->ensurePolished();
      view->replot();
      view->grab();
      views_.push_back(std::move(view));
    }
  }

  void Draw(QPixmap& target) {
    constexpr double kStep = 0.02;  // s
    shift_ += kStep;
    for (auto& view : views_) {
      view->setAxisScale(QwtAxis::XBottom, shift_, seconds_ + shift_);
      view->replot();
      view->render(&target);
    }
  }

 private:
  std::vector<std::unique_ptr<QwtPlot>> views_;
  double seconds_;
  double shift_ = 0;
};

/// Both kinds of plots, created when they are first measured.
class Bench {
 public:
  explicit Bench(const Scenery& scenery) : ours_(scenery), stock_(scenery), target_(scenery.size) {}

  double DrawOurs() {
    return MillisecondsOf([this] { ours_.Draw(target_); });
  }
  double DrawStock() {
    return MillisecondsOf([this] { stock_.Draw(target_); });
  }

 private:
  template <typename Frame>
  static double MillisecondsOf(Frame frame) {
    constexpr double kMilli = 1e-6;
    return NanosecondsEach(1, [&](std::uint64_t) { frame(); }) * kMilli;
  }

  CanvasApplication application_;  // must exist before all widgets
  Ours ours_;
  Stock stock_;
  QPixmap target_;
};

std::function<std::optional<Pair>()> Drawing(const Scenery& scenery) {
  const auto bench = std::make_shared<std::unique_ptr<Bench>>();
  const auto made = [bench, scenery]() -> Bench& {
    if (!*bench) *bench = std::make_unique<Bench>(scenery);
    return **bench;
  };
  const auto measure =
      SideBySide({[made] { return made().DrawOurs(); }}, {[made] { return made().DrawStock(); }});
  return [made, measure] {
    made();  // creates the plots outside of the measurement
    return measure();
  };
}

}  // namespace

std::vector<Case> PlotCases(const Effort& effort) {
  const int seconds = effort.is_tiny ? 1 : 60;
  const Scenery one{.curves = 10, .size = {1200, 400}, .seconds = seconds};
  const Scenery many{.plots = 16, .curves = 3, .size = {300, 200}, .seconds = seconds};
  struct Kind {
    const char* suffix;
    const char* what;
    Signal signal;
    double columns;
  };
  std::vector<Case> cases;
  for (const Kind& kind :
       {Kind{"", "", Signal::kSmooth, kLive}, Kind{"-noi", ", white noise", Signal::kNoise, kLive},
        Kind{"-new", ", drawn anew", Signal::kSmooth, kAnew},
        Kind{"-nn", ", noise, drawn anew", Signal::kNoise, kAnew}}) {
    const auto add = [&](const char* id, const char* what, Scenery scenery, double gate,
                         double stretch) {
      scenery.signal = kind.signal;
      scenery.columns = kind.columns;
      cases.push_back({.id = std::string(id) + kind.suffix,
                       .what = std::string(what) + kind.what + " / Qwt",
                       .unit = "ms",
                       .gate = gate,
                       .stretch = stretch,
                       .repetition = Drawing(scenery)});
    };
    add("V1", "plot of 10 curves x 60 s", one, 0.5, 0.3);
    add("V2", "16 plots of 3 curves", many, 0.7, 0.4);
  }
  return cases;
}

}  // namespace tendon::benchmark
