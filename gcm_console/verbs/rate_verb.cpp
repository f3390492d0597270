#include <gcm_console/catalogue/telemetry_column.h>
#include <gcm_console/output/table.h>
#include <gcm_console/output/text.h>
#include <gcm_console/verbs/common_options.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/base/os/termination.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace console {
namespace {

using namespace std::chrono_literals;

struct RateOptions {
  std::string path;
  std::uint64_t count = 0;  // number of reports; 0: no limit
  double seconds = 0.0;     // 0: no limit
};

/// Figures about the rows of one interval.
struct Rate {
  std::uint64_t rows = 0;
  std::uint64_t lost = 0;
  std::uint64_t periods = 0;
  double sum = 0.0;      // sum of the periods, in s
  double squares = 0.0;  // sum of the squared periods
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0.0;

  [[nodiscard]] double mean() const { return sum / static_cast<double>(periods); }
  /// Returns the standard deviation of the periods.
  [[nodiscard]] double jitter() const {
    return std::sqrt(std::max(0.0, squares / static_cast<double>(periods) - mean() * mean()));
  }
};

/// Measures the rate by the clock of the source, so that the network does not influence it.
class RateMeter final : public tendon::RowSink {
 public:
  void OnSubscribed(const std::vector<tendon::Schema>& /*columns*/) override {}
  void OnRows(const tendon::RowBatch& batch) override {
    constexpr double kNanosecond = 1e-9;
    const std::scoped_lock lock(mutex_);
    rate_.lost += batch.lost.all();
    for (std::size_t row = 0; row < batch.count; ++row) {
      ++rate_.rows;
      const bool follows =
          last_tick_ && batch.epoch == epoch_ && batch.ticks[row] == *last_tick_ + 1;
      if (follows) Add(static_cast<double>(batch.times[row] - last_time_) * kNanosecond);
      last_tick_ = batch.ticks[row];
      last_time_ = batch.times[row];
      epoch_ = batch.epoch;
    }
  }
  void OnStale(const tendon::Error& reason) override {
    const std::scoped_lock lock(mutex_);
    complaint_ = reason.message;
  }

  /// Returns the figures since the last call.
  Rate Take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(rate_, {});
  }
  std::string TakeComplaint() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(complaint_, {});
  }

 private:
  void Add(double period) {
    ++rate_.periods;
    rate_.sum += period;
    rate_.squares += period * period;
    rate_.shortest = std::min(rate_.shortest, period);
    rate_.longest = std::max(rate_.longest, period);
  }

  std::mutex mutex_;
  Rate rate_;
  std::optional<std::uint64_t> last_tick_;
  std::int64_t last_time_ = 0;
  std::uint64_t epoch_ = 0;
  std::string complaint_;
};

/// Prints a table line by line. The column widths are fixed at the start: later lines are not known
/// yet.
class RateReport {
 public:
  explicit RateReport(Context& context) : context_(context) {}

  void Print(const Rate& rate) {
    if (context_.settings().json) return PrintJson(rate);
    if (!has_begun_ && context_.columns() > 0 && context_.settings().titles) {
      PrintCells({"RATE/Hz", "PERIOD/ms", "SHORTEST/ms", "LONGEST/ms", "JITTER/ms", "LOST"});
    }
    has_begun_ = true;
    if (rate.periods == 0) {
      return PrintCells({"0.0", "-", "-", "-", "-", std::to_string(rate.lost)});
    }
    constexpr double kMilli = 1e3;
    PrintCells({Fixed(1.0 / rate.mean(), 1), Fixed(rate.mean() * kMilli, 3),
                Fixed(rate.shortest * kMilli, 3), Fixed(rate.longest * kMilli, 3),
                Fixed(rate.jitter() * kMilli, 3), std::to_string(rate.lost)});
  }

 private:
  void PrintCells(const std::vector<std::string>& cells) {
    constexpr std::size_t kWidth = 11;
    const bool is_aligned = context_.columns() > 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::size_t fill = cells[i].size() < kWidth ? kWidth - cells[i].size() : 0;
      context_.out() << (i == 0       ? ""
                         : is_aligned ? "  "
                                      : "\t")
                     << std::string(is_aligned ? fill : 0, ' ') << cells[i];
    }
    context_.out() << '\n';
  }
  void PrintJson(const Rate& rate) {
    nlohmann::ordered_json line = {{"rows", rate.rows}, {"lost", rate.lost}};
    if (rate.periods > 0) {
      line["rate_hz"] = 1.0 / rate.mean();
      line["period_s"] = rate.mean();
      line["shortest_s"] = rate.shortest;
      line["longest_s"] = rate.longest;
      line["jitter_s"] = rate.jitter();
    }
    context_.PrintJsonLine(line);
  }

  Context& context_;
  bool has_begun_ = false;
};

Result<ExitCode> MeasureRate(Context& context, const RateOptions& options) {
  tendon::os::HoldTerminationSignals();
  const auto client = context.Client();
  if (!client) return client.error();
  const auto subscription = WholeTable((*client)->catalogue(), options.path);
  if (!subscription) return subscription.error();
  const auto meter = std::make_shared<RateMeter>();
  const auto id = (*client)->telemetry().Subscribe(*subscription, meter);
  const auto begin = std::chrono::steady_clock::now();
  RateReport report(context);
  bool is_interrupted = false;
  std::uint64_t reports = 0;
  auto next = begin + 1s;
  const auto wants_more = [&] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    return (options.count == 0 || reports < options.count) && context.out().good() &&
           (options.seconds == 0.0 || passed.count() < options.seconds);
  };
  while (wants_more() && !is_interrupted) {
    is_interrupted = tendon::os::TerminationRequested(20ms);
    if (const std::string complaint = meter->TakeComplaint(); !complaint.empty()) {
      context.err() << "gcm: " << Plain(complaint) << '\n';
    }
    if (std::chrono::steady_clock::now() < next) continue;
    next += 1s;
    ++reports;
    report.Print(meter->Take());
    context.out().flush();
  }
  // If the user interrupts within the first second, prints a report for this time.
  if (reports == 0) report.Print(meter->Take());
  (*client)->telemetry().Unsubscribe(id);
  return is_interrupted ? program::kInterrupted : program::kOk;
}

Verb::Run PrepareRate(CLI::App& app) {
  auto options = std::make_shared<RateOptions>();
  WithKind(app.add_option("path", options->path, "a state table, or a column of a state table"),
           WordKind::kColumn)
      ->required();
  AddCount(app, options->count, "end after this many lines; one line is printed each second");
  AddDuration(app, options->seconds);
  return [options](Context& context) { return MeasureRate(context, *options); };
}

}  // namespace

std::vector<Verb> RateVerbs() {
  return {{"hz",
           "measure the rows per second of a state table",
           &PrepareRate,
           {"gcm hz robot/arm/state", "gcm hz robot/arm/state --count 1"}}};
}

}  // namespace console
