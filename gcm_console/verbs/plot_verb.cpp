#include <gcm_console/catalogue/telemetry_column.h>
#include <gcm_console/report.h>
#include <gcm_console/screen/braille.h>
#include <gcm_console/screen/screen.h>
#include <gcm_console/verb.h>
#include <program/command_line.h>
#include <tendon/base/os/screen/keyboard.h>
#include <tendon/base/os/terminal.h>
#include <tendon/base/os/termination.h>
#include <tendon/payload/plot_channel.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>

namespace console {
namespace {

using program::ExitCode;
using tendon::Error;
using tendon::Result;
using namespace std::chrono_literals;

struct PlotOptions {
  std::vector<std::string> paths;
  double window = 10.0;  // s that are shown
  double seconds = 0.0;  // 0: no end on a terminal, the window elsewhere
};

struct Sample {
  double time = 0.0;  // s on the source's clock
  double value = 0.0;
};

/// One number of a column over the last seconds.
struct Curve {
  std::string title;
  std::string unit;
  std::deque<Sample> samples;
};

class PlotListener final : public tendon::RowSink {
 public:
  PlotListener(std::vector<RowPrinter::Wanted> wanted, double window)
      : wanted_(std::move(wanted)), window_(window) {}

  void OnSubscribed(const std::vector<tendon::Schema>& columns) override {
    const std::scoped_lock lock(mutex_);
    channels_.clear();
    curves_.clear();
    complaint_.clear();
    for (const auto& [path, column, is_found] : wanted_) {
      const auto channel = tendon::FindChannel(columns.at(column), path.field);
      if (!channel) {
        mistake_ = Error{channel.error().code, ToString(path) + ": " + channel.error().message};
        return;
      }
      channels_.push_back(*channel);
      curves_.push_back({ToString(path), channel->unit, {}});
    }
  }
  std::size_t OnRows(const tendon::RowBatch& batch) override {
    constexpr double kNanosecond = 1e-9;
    const std::scoped_lock lock(mutex_);
    for (std::size_t row = 0; row < batch.count; ++row) {
      const double time = static_cast<double>(batch.times[row]) * kNanosecond;
      for (std::size_t i = 0; i < curves_.size(); ++i) {
        const auto value = ReadChannel(channels_[i], batch.cell(row, wanted_[i].column));
        if (value && std::isfinite(*value)) curves_[i].samples.push_back({time, *value});
      }
    }
    for (Curve& curve : curves_) {
      auto& samples = curve.samples;
      while (!samples.empty() && samples.back().time - samples.front().time > window_) {
        samples.pop_front();
      }
    }
    return 0;
  }
  void OnStale(const Error& reason) override {
    const std::scoped_lock lock(mutex_);
    complaint_ = reason.message;
  }

  std::vector<Curve> curves() {
    const std::scoped_lock lock(mutex_);
    return curves_;
  }
  std::optional<Error> mistake() {
    const std::scoped_lock lock(mutex_);
    return mistake_;
  }
  std::string complaint() {
    const std::scoped_lock lock(mutex_);
    return complaint_;
  }

 private:
  const std::vector<RowPrinter::Wanted> wanted_;
  const double window_;
  std::mutex mutex_;
  std::vector<tendon::PlotChannel> channels_;
  std::vector<Curve> curves_;
  std::optional<Error> mistake_;
  std::string complaint_;
};

constexpr int kMargin = 12;  // letters, for the scale

/// The curve from its lowest value to its highest, the newest sample at the right.
void Draw(const Curve& curve, double window, int columns, int rows, std::ostream& picture) {
  const auto& samples = curve.samples;
  picture << curve.title;
  if (samples.empty()) {
    picture << "  no values yet\n";
    return;
  }
  const auto [lowest, highest] =
      std::minmax_element(samples.begin(), samples.end(),
                          [](const Sample& a, const Sample& b) { return a.value < b.value; });
  const double low = lowest->value;
  const double high = highest->value;
  const bool is_flat = high <= low;
  picture << " = " << Short(samples.back().value)
          << (curve.unit.empty() ? "" : " " + Plain(curve.unit)) << '\n';
  BrailleCanvas canvas(columns - kMargin, rows);
  const auto x_of = [&](const Sample& sample) {
    const double age = samples.back().time - sample.time;
    return canvas.width() - 1 - static_cast<int>(age / window * (canvas.width() - 1));
  };
  const auto y_of = [&](const Sample& sample) {
    if (is_flat) return canvas.height() / 2;
    return static_cast<int>(
        std::lround((high - sample.value) / (high - low) * (canvas.height() - 1)));
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& before = samples[i == 0 ? 0 : i - 1];
    canvas.Line(x_of(before), y_of(before), x_of(samples[i]), y_of(samples[i]));
  }
  for (int row = 0; row < rows; ++row) {
    const bool is_labelled = is_flat ? row == rows / 2 : row == 0 || row == rows - 1;
    const std::string scale = is_labelled ? Short(row == 0 ? high : low) : "";
    picture << std::string(kMargin - 2 - std::min<std::size_t>(scale.size(), kMargin - 2), ' ')
            << scale << "  " << canvas.Row(row) << '\n';
  }
}

std::string PictureOf(const std::vector<Curve>& curves, double window, int columns, int rows) {
  constexpr int kFewestRows = 3;
  constexpr int kFewestColumns = kMargin + 8;
  std::ostringstream picture;
  const int each = curves.empty() ? rows : (rows - 1) / static_cast<int>(curves.size()) - 1;
  const int wide = std::max(columns, kFewestColumns);
  for (const Curve& curve : curves) {
    Draw(curve, window, wide, std::max(each, kFewestRows), picture);
  }
  const std::string from = "-" + Short(window) + " s";
  const int gap = wide - kMargin - static_cast<int>(from.size()) - 3;
  picture << std::string(kMargin, ' ') << from
          << std::string(static_cast<std::size_t>(std::max(gap, 1)), ' ') << "now\n";
  return picture.str();
}

/// Until the time is over, or somebody wants the end.
Result<ExitCode> Collect(Context& context, PlotListener& listener, const PlotOptions& options) {
  const bool is_typed = context.streams().make_line_reader != nullptr;
  const double seconds = options.seconds > 0.0 || is_typed ? options.seconds : options.window;
  const auto begin = std::chrono::steady_clock::now();
  std::optional<tendon::os::Keyboard> keyboard;
  std::optional<Screen> screen;
  if (is_typed) {
    keyboard.emplace();
    screen.emplace(context.out());
  }
  while (true) {
    if (tendon::os::TerminationAsked(keyboard ? 0ms : 50ms)) return program::kInterrupted;
    if (const auto mistake = listener.mistake()) return *mistake;
    if (keyboard) {
      const int rows = tendon::os::TerminalRows();
      const int columns = tendon::os::TerminalColumns(tendon::os::Stream::kOutput);
      screen->Show(PictureOf(listener.curves(), options.window, columns, rows - 2),
                   Plain(listener.complaint()), rows);
      if (keyboard->NextKey(100ms) == 'q') return program::kOk;
      screen->PauseIfAsked(*keyboard);
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    if (seconds > 0.0 && passed.count() >= seconds) return program::kOk;
  }
}

Result<ExitCode> Plot(Context& context, const PlotOptions& options) {
  constexpr int kUsualColumns = 80;
  constexpr int kUsualRows = 20;
  if (context.settings().json) {
    return Error{tendon::ErrorCode::kInvalid, "plot only draws; for the numbers: gcm --json watch"};
  }
  tendon::os::HoldTerminationSignals();
  const auto client = context.Client();
  if (!client) return client.error();
  const auto choice = ColumnsThatFit((*client)->catalog(), options.paths);
  if (!choice) return choice.error();
  const auto& tables = choice->tables;
  if (tables.size() > 1) {
    return Error{tendon::ErrorCode::kInvalid,
                 "'" + ToString(tables[1].wanted.front().path) + "' is in another table than '" +
                     ToString(tables.front().wanted.front().path) + "'; plot one table at a time"};
  }
  auto [subscription, wanted] = tables.front();
  const int columns = context.columns() > 0 ? context.columns() : kUsualColumns;
  const std::chrono::duration<double> dot(options.window / (2.0 * columns));
  subscription.rows.period = std::chrono::duration_cast<std::chrono::nanoseconds>(dot);
  const auto listener = std::make_shared<PlotListener>(wanted, options.window);
  const auto id = (*client)->telemetry().Subscribe(subscription, listener);
  const auto ended = Collect(context, *listener, options);
  (*client)->telemetry().Unsubscribe(id);
  if (!ended) return ended;
  if (const std::string complaint = listener->complaint(); !complaint.empty()) {
    context.err() << "gcm: " << Plain(complaint) << '\n';
  }
  // The last picture stays when the screen is given back.
  context.out() << PictureOf(listener->curves(), options.window, columns, kUsualRows);
  return ended;
}

Verb::Run Prepare(CLI::App& app) {
  auto options = std::make_shared<PlotOptions>();
  Names(app.add_option("paths", options->paths, "numbers in columns of one table"),
        WordKind::kColumn)
      ->required();
  app.add_option("--window", options->window, "how much time is shown (default: 10s)")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformDuration, ""));
  app.add_option("--for", options->seconds, "end after so long (into a pipe: the window)")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformDuration, ""));
  return [options](Context& context) { return Plot(context, *options); };
}

}  // namespace

std::vector<Verb> PlotVerbs() {
  return {{"plot",
           "draw numbers over time; q ends it",
           &Prepare,
           {"gcm plot robot/arm/state.Joints.position[0] robot/arm/state.Joints.velocity[0]"}}};
}

}  // namespace console
