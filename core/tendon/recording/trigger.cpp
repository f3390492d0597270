#include <tendon/recording/trigger.h>

#include <tendon/base/name.h>
#include <tendon/base/text.h>
#include <tendon/gcm/lookup.h>
#include <tendon/interface/observed_call.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tendon::recording {
namespace {

Error NoSuch(const Condition& condition, const std::string& what) {
  return {ErrorCode::kNotFound, Quoted(condition.text, 200) + ": " + what};
}

}  // namespace

/// When the condition was true.
class Trigger::Matches {
 public:
  explicit Matches(std::function<void()> on_match) : on_match_(std::move(on_match)) {}

  void Add(const std::vector<SteadyTime>& times) {
    constexpr std::size_t kMax = 4096;
    if (times.empty()) return;
    {
      const std::scoped_lock lock(mutex_);
      times_.insert(times_.end(), times.begin(), times.end());
      while (times_.size() > kMax) times_.pop_front();
    }
    on_match_();
  }
  std::optional<SteadyTime> FirstAfter(SteadyTime time) {
    const std::scoped_lock lock(mutex_);
    while (!times_.empty() && times_.front() <= time) times_.pop_front();
    if (times_.empty()) return std::nullopt;
    return times_.front();
  }

 private:
  const std::function<void()> on_match_;
  std::mutex mutex_;
  std::deque<SteadyTime> times_;
};

class Trigger::TableWatch final : public RowSink {
 public:
  TableWatch(Condition condition, std::shared_ptr<Matches> matches)
      : condition_(std::move(condition)), matches_(std::move(matches)) {}

  /// A restarted process may use another type for the column; then no row matches.
  void OnSubscribed(const std::vector<Schema>& columns) override {
    auto test = CellTest::Make(condition_, columns.front());
    const std::scoped_lock lock(mutex_);
    test_.reset();
    if (test) test_.emplace(*std::move(test));
  }
  void OnRows(const RowBatch& batch) override {
    std::vector<SteadyTime> times;
    {
      const std::scoped_lock lock(mutex_);
      for (std::size_t row = 0; test_ && row < batch.count; ++row) {
        if (!test_->IsTrue(batch.cell(row, 0))) continue;
        times.emplace_back(std::chrono::nanoseconds(batch.times[row]) - batch.clock_offset);
      }
    }
    matches_->Add(times);
  }
  void OnStale(const Error& /*reason*/) override {}

 private:
  const Condition condition_;
  const std::shared_ptr<Matches> matches_;
  std::mutex mutex_;
  std::optional<CellTest> test_;
};

/// Waits for events, or for the end of a call of a command, unless the call was refused. A call
/// matches only when it ends, because the rows from its start on may no longer be kept.
class Trigger::EventWatch final : public EventSink {
 public:
  EventWatch(std::shared_ptr<Matches> matches, bool is_command)
      : matches_(std::move(matches)), is_command_(is_command) {}

  void OnListening(const std::vector<MemberDescription>& /*events*/) override {}
  void OnEvent(std::size_t /*event*/, std::span<const std::byte> value,
               const EventTime& time) override {
    if (!is_command_ || WasExecuted(HeaderOfCall(value).outcome)) matches_->Add({time.raised});
  }
  void OnEventsLost(std::size_t /*event*/, std::uint64_t /*lost*/) override {}
  void OnStale(const Error& /*reason*/) override {}

 private:
  const std::shared_ptr<Matches> matches_;
  const bool is_command_;
};

Result<std::unique_ptr<Trigger>> Trigger::Make(RecordedSystem& system, const Condition& condition,
                                               std::function<void()> on_match) {
  auto matches = std::make_shared<Matches>(std::move(on_match));
  std::unique_ptr<Trigger> trigger(new Trigger(system, std::move(matches)));
  const Catalogue catalogue = system.catalogue();
  const auto watched = condition.comparison ? trigger->WatchTable(condition, catalogue)
                                            : trigger->WatchEvent(condition, catalogue);
  if (!watched) return watched.error();
  return trigger;
}

Trigger::~Trigger() {
  if (table_) system_.telemetry().Unsubscribe(*table_);
  if (event_) system_.StopListening(*event_);
}

std::optional<SteadyTime> Trigger::FirstAfter(SteadyTime time) {
  return matches_->FirstAfter(time);
}

Result<void> Trigger::WatchTable(const Condition& condition, const Catalogue& catalogue) {
  const Path& path = condition.path;
  const auto component = LookUpComponent(catalogue, path.process, path.component);
  if (!component) return NoSuch(condition, component.error().message);
  const std::string where = path.process + "/" + path.component;
  const auto* table = FindNamed((*component)->tables, path.interface);
  if (table == nullptr) {
    std::vector<std::string> known;
    for (const auto& one : (*component)->tables) known.push_back(one.name);
    return NoSuch(condition, where + " has no state table '" + path.interface + "'" +
                                 DidYouMean(path.interface, known) +
                                 "; only values of state tables can be compared");
  }
  const auto* column = FindNamed(table->columns, path.member);
  if (column == nullptr) {
    std::vector<std::string> known;
    for (const auto& one : table->columns) known.push_back(one.name);
    return NoSuch(condition, where + "/" + path.interface + " has no column '" + path.member + "'" +
                                 DidYouMean(path.member, known));
  }
  const auto type = system_.FindSchema(path.process, column->fingerprint);
  if (!type) return type.error();
  if (const auto test = CellTest::Make(condition, *type); !test) return test.error();
  table_ = system_.telemetry().Subscribe({.process = path.process,
                                          .component = path.component,
                                          .table = path.interface,
                                          .columns = {path.member}},
                                         std::make_shared<TableWatch>(condition, matches_));
  return {};
}

Result<void> Trigger::WatchEvent(const Condition& condition, const Catalogue& catalogue) {
  const Path& path = condition.path;
  if (const auto component = LookUpComponent(catalogue, path.process, path.component); !component) {
    return NoSuch(condition, component.error().message);
  } else if (FindNamed((*component)->tables, path.interface) != nullptr) {
    return Error{ErrorCode::kInvalid,
                 Quoted(condition.text, 200) +
                     " is a value: expected a comparison after the path, such as > 1.5"};
  }
  const auto provided = LookUpProvided(catalogue, path.interface_name());
  if (!provided) return NoSuch(condition, provided.error().message);
  EventSubscription wanted{.provided = path.interface_name(), .events = {}};
  const MemberDescription* command = FindNamed((*provided)->commands, path.member);
  const bool is_command = command != nullptr && CanBeObserved(command->signature);
  const bool is_event = FindNamed((*provided)->events, path.member) != nullptr;
  if (!path.field.empty() || (!is_event && !is_command)) {
    std::vector<std::string> known;
    for (const auto& one : (*provided)->events) known.push_back(one.name);
    for (const auto& one : (*provided)->commands) known.push_back(one.name);
    return NoSuch(condition, ToString(path.interface_name()) + " has no event or command '" +
                                 path.member + path.field + "'" + DidYouMean(path.member, known));
  }
  (is_event ? wanted.events : wanted.commands) = {path.member};
  event_ = system_.Listen(wanted, std::make_shared<EventWatch>(matches_, !is_event));
  return {};
}

}  // namespace tendon::recording
