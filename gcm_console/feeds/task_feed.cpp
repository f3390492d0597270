#include <gcm_console/feeds/task_feed.h>

#include <gcm_console/catalogue/telemetry_column.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/staleness.h>
#include <tendon/gcm/waiting.h>
#include <tendon/payload/numeric_field.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace console {
namespace {

constexpr const char* kSummary = "CycleSummary";
constexpr const char* kCycle = "Cycle";

bool HasColumns(const tendon::ComponentDescription& component) {
  for (const auto& table : component.tables) {
    if (table.name != "state") continue;
    const auto has = [&](const std::string& name) {
      return std::any_of(table.columns.begin(), table.columns.end(),
                         [&](const auto& column) { return column.name == name; });
    };
    return has(kSummary) && has(kCycle);
  }
  return false;
}

}  // namespace

/// Stores the newest figures of one task.
class TaskFeed::Listener final : public tendon::RowSink {
 public:
  void OnSubscribed(const std::vector<tendon::Schema>& columns) override {
    const std::scoped_lock lock(mutex_);
    const auto find = [&](std::size_t column,
                          const char* path) -> std::optional<tendon::NumericField> {
      auto field = tendon::FindNumericField(columns.at(column), path);
      return field ? std::optional(*std::move(field)) : std::nullopt;
    };
    cycles_ = find(0, ".cycles");
    period_ = find(0, ".period.mean");
    late_ = find(0, ".lateness.p50");
    latest_ = find(0, ".lateness.max");
    compute_ = find(0, ".compute.mean");
    skipped_ = find(1, ".overruns");
  }
  void OnRows(const tendon::RowBatch& batch) override {
    const std::scoped_lock lock(mutex_);
    if (batch.count == 0) return;
    const std::size_t row = batch.count - 1;
    written_ = NewestTimeOf(batch);
    const auto value = [&](const std::optional<tendon::NumericField>& field, std::size_t column) {
      return field ? ReadAsDouble(*field, batch.cell(row, column)).value_or(0.0) : 0.0;
    };
    figures_.skipped = static_cast<std::uint64_t>(value(skipped_, 1));
    const double period = value(period_, 0);
    figures_.is_known = value(cycles_, 0) > 0 && period > 0.0;
    if (!figures_.is_known) return;
    figures_.rate = 1.0 / period;
    figures_.late = value(late_, 0);
    figures_.latest = value(latest_, 0);
    figures_.compute = value(compute_, 0);
    figures_.load = figures_.compute / period;
  }
  void OnStale(const tendon::Error& /*reason*/) override {
    const std::scoped_lock lock(mutex_);
    figures_ = {};
  }

  TaskFigures figures() {
    const std::scoped_lock lock(mutex_);
    return figures_;
  }
  /// Returns the time since the newest row was written.
  std::optional<std::chrono::nanoseconds> age() {
    const std::scoped_lock lock(mutex_);
    return written_ ? std::optional(AgeOf(*written_)) : std::nullopt;
  }

 private:
  std::mutex mutex_;
  TaskFigures figures_;
  std::optional<std::chrono::nanoseconds> written_;
  std::optional<tendon::NumericField> cycles_;
  std::optional<tendon::NumericField> period_;
  std::optional<tendon::NumericField> late_;
  std::optional<tendon::NumericField> latest_;
  std::optional<tendon::NumericField> compute_;
  std::optional<tendon::NumericField> skipped_;
};

TaskFeed::~TaskFeed() {
  for (const auto& [path, entry] : entries_) client_.telemetry().Unsubscribe(entry.id);
}

std::vector<TaskFigures> TaskFeed::Look() {
  constexpr std::chrono::milliseconds kOften(200);
  std::vector<TaskFigures> all;
  std::map<std::string, Entry> there;
  const tendon::Catalogue catalogue = client_.catalogue();
  for (const auto& [process, entry] : catalogue.processes()) {
    for (const auto& [name, component] : entry.components) {
      if (!HasColumns(component) || !IsPresent(entry.process)) continue;
      const std::string path = process + "/" + name;
      if (!only_.empty() && path != only_) continue;
      auto known = entries_.extract(path);
      if (known.empty()) {
        const auto listener = std::make_shared<Listener>();
        tendon::TableSubscription wanted{process, name, "state", {kSummary, kCycle}};
        wanted.rows = {.period = kOften, .delivery = tendon::RowDelivery::kNewest};
        there[path] = {client_.telemetry().Subscribe(wanted, listener), listener};
      } else {
        there.insert(std::move(known));
      }
      Listener& listener = *there[path].listener;
      const auto why = StaleReasonOf(entry.process.state, component.state);
      const bool is_old = IsStale(why, listener.age(), 0);
      TaskFigures figures = is_old ? TaskFigures() : listener.figures();
      if (is_old) figures.age = listener.age();
      figures.path = path;
      figures.state = ToString(component.state);
      figures.detail = WaitingText(WaitsOf(entry, component));
      figures.period = component.period;
      const bool is_alive = entry.process.state == tendon::ProcessState::kAlive;
      figures.is_awaited = is_alive && (is_old ? !figures.age : !figures.is_known);
      all.push_back(std::move(figures));
    }
  }
  for (const auto& [path, entry] : entries_) client_.telemetry().Unsubscribe(entry.id);
  entries_ = std::move(there);
  return all;
}

}  // namespace console
