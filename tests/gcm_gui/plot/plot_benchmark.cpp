// V1 and V2: how long a frame of our plots takes, against stock Qwt with its aggressive filter on
// the same data. Both draw the whole canvas, axes and grid, all axes moving; frame by frame in
// turns, and the ratio is the median of the pairs'.

#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/theme/theme.h>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>

#include <QApplication>
#include <QPixmap>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

namespace {

using tendon::gui::PlotView;
using tendon::gui::Sample;

constexpr int kSeconds = 60;
constexpr int kRate = 1000;
constexpr int kRows = kSeconds * kRate;
constexpr int kPairs = 31;

enum class Signal { kSmooth, kNoise };

constexpr double kLive = 1;  // columns from frame to frame
constexpr double kAnew = 1.377;

struct Case {
  const char* name;
  const char* signal_name;
  Signal signal;
  int plots;
  int curves;
  QSize size;
  double columns;
  double gate;
};

std::vector<double> ValuesOf(Signal signal, int curve) {
  std::mt19937 random(static_cast<unsigned>(curve));
  std::normal_distribution<double> gauss;
  std::vector<double> values(kRows);
  for (int i = 0; i < kRows; ++i) {
    const double phase = 2 * std::numbers::pi * (i * 3.0 / kRows + curve * 0.1);
    values[static_cast<std::size_t>(i)] =
        signal == Signal::kSmooth ? std::sin(phase) + 0.01 * gauss(random) : gauss(random);
  }
  return values;
}

class Ours {
 public:
  explicit Ours(const Case& c) : columns_(c.columns) {
    for (int plot = 0; plot < c.plots; ++plot) {
      auto view = std::make_unique<PlotView>();
      view->resize(c.size);
      view->setWindow(std::chrono::seconds(kSeconds));
      for (int i = 0; i < c.curves; ++i) {
        const std::vector<double> values = ValuesOf(c.signal, i);
        std::vector<Sample> rows;
        for (int row = 0; row < kRows; ++row) {
          rows.push_back({.time_ns = row * 1'000'000LL,
                          .tick = static_cast<std::uint64_t>(row),
                          .value = values[static_cast<std::size_t>(row)]});
        }
        view->addCurve({QString("p/c%1/state.x").arg(i), "rad"}).append(rows);
      }
      view->ensurePolished();
      view->refresh();
      view->grab();
      views_.push_back(std::move(view));
    }
  }

  void drawFrame(QPixmap& target) {
    for (auto& view : views_) {
      view->panTime(columns_);
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
  explicit Stock(const Case& c) {
    for (int plot = 0; plot < c.plots; ++plot) {
      auto view = std::make_unique<QwtPlot>();
      view->resize(c.size);
      (new QwtPlotGrid)->attach(view.get());
      std::vector<double> times(kRows);
      for (int i = 0; i < kRows; ++i) times[static_cast<std::size_t>(i)] = i / double{kRate};
      for (int i = 0; i < c.curves; ++i) {
        const std::vector<double> values = ValuesOf(c.signal, i);
        auto* curve = new QwtPlotCurve;
        curve->setSamples(times.data(), values.data(), kRows);
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

  void drawFrame(QPixmap& target) {
    shift_ += 0.02;
    for (auto& view : views_) {
      view->setAxisScale(QwtAxis::XBottom, shift_, kSeconds + shift_);
      view->replot();
      view->render(&target);
    }
  }

 private:
  std::vector<std::unique_ptr<QwtPlot>> views_;
  double shift_ = 0;
};

double Milliseconds(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void Measure(const Case& c) {
  Ours ours(c);
  Stock stock(c);
  QPixmap target(c.size);
  std::vector<double> our_times;
  std::vector<double> floor_times;
  std::vector<double> ratios;
  for (int i = 0; i < kPairs; ++i) {
    our_times.push_back(Milliseconds([&] { ours.drawFrame(target); }));
    floor_times.push_back(Milliseconds([&] { stock.drawFrame(target); }));
    ratios.push_back(our_times.back() / floor_times.back());
  }
  const double ratio = Median(ratios);
  std::printf("%-3s %-7s %-5s %9.2f ms %9.2f ms %7.2f   <= %.2f  %s\n", c.name, c.signal_name,
              c.columns == kLive ? "live" : "anew", Median(our_times), Median(floor_times), ratio,
              c.gate, ratio <= c.gate ? "holds" : "FAILS");
}

}  // namespace

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application(argc, argv);
  tendon::gui::Theme::instance().choose(tendon::gui::Theme::Choice::kDark);
  std::printf("%-3s %-7s %-5s %12s %12s %7s   %-7s %s\n", "", "signal", "frame", "ours", "floor",
              "ratio", "gate", "verdict");
  for (const double columns : {kLive, kAnew}) {
    Measure({"V1", "smooth", Signal::kSmooth, 1, 10, {1200, 400}, columns, 0.5});
    Measure({"V1", "noise", Signal::kNoise, 1, 10, {1200, 400}, columns, 0.5});
    Measure({"V2", "smooth", Signal::kSmooth, 16, 3, {300, 200}, columns, 0.7});
    Measure({"V2", "noise", Signal::kNoise, 16, 3, {300, 200}, columns, 0.7});
  }
  return 0;
}
