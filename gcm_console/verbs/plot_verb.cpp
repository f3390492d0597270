#include <gcm_console/catalogue/telemetry_column.h>
#include <gcm_console/feeds/curve_feed.h>
#include <gcm_console/feeds/first_mistake.h>
#include <gcm_console/output/curve_picture.h>
#include <gcm_console/output/screen.h>
#include <gcm_console/output/table.h>
#include <gcm_console/verbs/common_options.h>
#include <gcm_console/verbs/verb.h>
#include <program/command_line.h>
#include <tendon/base/os/keyboard.h>
#include <tendon/base/os/terminal.h>
#include <tendon/base/os/termination.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>
#include <optional>

namespace console {
namespace {

using program::ExitCode;
using tendon::Error;
using tendon::Result;
using namespace std::chrono_literals;

struct PlotOptions {
  std::vector<std::string> paths;
  double window = 10.0;  // visible time span in s
  double seconds = 0.0;  // 0: without limit on a terminal, otherwise as long as the window
};

/// The numbers that are plotted. The rows of different tables arrive independently.
class PlottedTables {
 public:
  PlottedTables(tendon::TelemetryClient& telemetry, const std::vector<TableChoice>& tables,
                double window, std::chrono::nanoseconds between)
      : telemetry_(telemetry) {
    for (TableChoice table : tables) {
      table.subscription.rows.period = between;
      const auto feed = std::make_shared<CurveFeed>(std::move(table.wanted), window);
      tables_.push_back({feed, telemetry.Subscribe(table.subscription, feed)});
    }
  }
  PlottedTables(const PlottedTables&) = delete;
  PlottedTables& operator=(const PlottedTables&) = delete;
  ~PlottedTables() {
    for (const Table& table : tables_) telemetry_.Unsubscribe(table.id);
  }

  [[nodiscard]] std::vector<NumberCurve> curves() const {
    std::vector<NumberCurve> all;
    for (const Table& table : tables_) std::ranges::move(table.feed->curves(), back_inserter(all));
    return all;
  }
  [[nodiscard]] std::optional<Error> mistake() const {
    return FirstMistake(tables_, &Table::feed,
                        "no matching value is a number; to list the columns with their types: gcm "
                        "ls -l -R --type state");
  }
  [[nodiscard]] std::vector<std::string> notes() const {
    std::vector<std::string> all;
    for (const Table& table : tables_) std::ranges::move(table.feed->notes(), back_inserter(all));
    return all;
  }

 private:
  struct Table {
    std::shared_ptr<CurveFeed> feed;
    tendon::TelemetryClient::Id id;
  };

  tendon::TelemetryClient& telemetry_;
  std::vector<Table> tables_;
};

/// Shows as many curves as fit on the screen. If some do not fit, a line at the bottom gives their
/// number.
void Show(const PlottedTables& plotted, double window, Screen& screen) {
  const int rows = tendon::os::TerminalRows();
  const int columns = tendon::os::TerminalColumns(tendon::os::Stream::kOutput);
  std::vector<NumberCurve> curves = plotted.curves();
  const std::vector<std::string> notes = plotted.notes();
  std::string footer = notes.empty() ? "" : notes.back();
  const auto fit = static_cast<std::size_t>(std::max(1, (rows - 3) / (kFewestCurveRows + 1)));
  if (curves.size() > fit) {
    footer = std::to_string(fit) + " of " + std::to_string(curves.size()) +
             " curves fit on this screen; give fewer values";
    curves.resize(fit);
  }
  screen.Show(PictureOf(curves, window, columns, rows - 2), Plain(footer), rows);
}

/// Collects samples until the time has passed or the user interrupts.
Result<ExitCode> Collect(Context& context, const PlottedTables& plotted,
                         const PlotOptions& options) {
  const bool has_screen = context.has_screen();
  const double seconds = options.seconds > 0.0 || has_screen ? options.seconds : options.window;
  const auto begin = std::chrono::steady_clock::now();
  std::optional<tendon::os::Keyboard> keyboard;
  std::optional<Screen> screen;
  if (has_screen) {
    keyboard.emplace();
    screen.emplace(context.out());
  }
  while (true) {
    if (tendon::os::TerminationRequested(keyboard ? 0ms : 50ms)) return program::kInterrupted;
    if (const auto mistake = plotted.mistake()) return *mistake;
    if (keyboard) {
      Show(plotted, options.window, *screen);
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
    return Error{tendon::ErrorCode::kInvalid,
                 "plot cannot print JSON; to get the numbers: gcm --json watch"};
  }
  tendon::os::HoldTerminationSignals();
  const auto client = context.Client();
  if (!client) return client.error();
  const auto choice = MatchingColumns((*client)->catalogue(), options.paths);
  if (!choice) return choice.error();
  const int columns = context.columns() > 0 ? context.columns() : kUsualColumns;
  const std::chrono::duration<double> dot(options.window / (2.0 * columns));
  const PlottedTables plotted((*client)->telemetry(), choice->tables, options.window,
                              std::chrono::duration_cast<std::chrono::nanoseconds>(dot));
  const auto ended = Collect(context, plotted, options);
  PrintSentences(plotted.notes(), context.err());
  if (!ended) return ended;
  // After the screen is restored, prints the last picture again.
  context.out() << PictureOf(plotted.curves(), options.window, columns, kUsualRows);
  return ended;
}

Verb::Run PreparePlot(CLI::App& app) {
  auto options = std::make_shared<PlotOptions>();
  WithKind(
      app.add_option("paths", options->paths,
                     "columns of state tables, or parts of columns (.position[0]); all numbers in "
                     "these columns are drawn; a pattern with * or ** matches several columns"),
      WordKind::kColumn)
      ->required();
  app.add_option("--window", options->window, "the time span that is shown (default: 10s)")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformDuration, ""));
  AddDuration(app, options->seconds,
              "end after this time (default in a pipe: the time of --window)");
  return [options](Context& context) { return Plot(context, *options); };
}

}  // namespace

std::vector<Verb> PlotVerbs() {
  return {{"plot",
           "draw numbers over time; the key q ends the plot",
           &PreparePlot,
           {"gcm plot robot/arm/state.Joints.position[0] robot/arm/state.Joints.velocity[0]",
            "gcm plot robot/arm/state.Joints.position"}}};
}

}  // namespace console
