#include <tendon/recording/replay.h>

#include <tendon/base/error.h>
#include <tendon/base/text.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;

constexpr auto kBetweenPasses = 10ms;
/// If a replay is later than this, it does not try to catch up, because a burst of rows could
/// overwrite rows that nobody has read yet. The tables keep rows for one second.
constexpr auto kMaxLate = 100ms;

// A recording may come from an untrusted source, so its use of this machine's resources is limited.
constexpr std::size_t kMaxTableBytes = std::size_t{1} << 30U;
constexpr std::chrono::hours kLongest(24 * 365 * 10);  // so that no sum of times overflows

/// Returns the memory that the state table of a source takes, in bytes.
std::size_t TableBytes(const RecordedSource& source, std::chrono::nanoseconds period) {
  std::size_t row = sizeof(std::uint64_t);
  for (const RecordedMember& member : source.members) row += member.largest + sizeof(std::uint64_t);
  return row * (StateTable::LengthFor(period, row) + 1);  // + 1: the row that is being written
}

LogLevel LogLevelOf(std::uint8_t ros_level) {
  if (ros_level >= 40) return LogLevel::kError;
  if (ros_level >= 30) return LogLevel::kWarning;
  return ros_level >= 20 ? LogLevel::kInfo : LogLevel::kDebug;
}

}  // namespace

Result<std::unique_ptr<Replay>> Replay::Open(std::unique_ptr<mcap::Reader> reader, mcap::Query part,
                                             ReplayOptions options) try {
  auto items = RecordingReader::Open(*reader, std::move(part));
  if (!items) return items.error();
  const std::string file = reader->name();
  std::unique_ptr<Replay> replay(
      new Replay(std::move(reader), *std::move(items), std::move(options)));
  const auto recorded = replay->recorded_processes();
  if (!replay->options_.as.empty() && recorded.size() > 1) {
    return Error{ErrorCode::kInvalid, "the name " + replay->options_.as +
                                          " is the name of one process, but the chosen part of " +
                                          file + " has several: " + Joined(recorded, ", ") +
                                          "; choose one of these processes with --paths"};
  }
  if (auto checked = replay->CheckSize(); !checked) return checked.error();
  return replay;
} catch (const std::exception& thrown) {
  return Error{ErrorCode::kFailed, std::string("cannot replay a recording: ") + thrown.what()};
}

/// Refuses a recording that would take too much memory, or more time than can be counted.
Result<void> Replay::CheckSize() const {
  const auto refuse = [this](const std::string& found) {
    return Error{ErrorCode::kInvalid, reader_->name() + " cannot be replayed: the chosen part " +
                                          found +
                                          "; choose a smaller part with --paths, --from "
                                          "and --to"};
  };
  std::size_t bytes = 0;
  for (const RecordedSource& source : items_->sources()) {
    if (source.is_table && source.count > 0) bytes += TableBytes(source, PeriodOf(source));
  }
  if (bytes > kMaxTableBytes) {
    return refuse("needs " + std::to_string(bytes) + " bytes for its state tables, more than " +
                  std::to_string(kMaxTableBytes));
  }
  const auto& counts = items_->counts();
  const double seconds = static_cast<double>(counts.last_time - counts.first_time) / 1e9;
  if (seconds / options_.rate > std::chrono::duration<double>(kLongest).count()) {
    return refuse("takes " + std::to_string(std::llround(seconds / options_.rate / 86'400)) +
                  " days, more than 3650");
  }
  return {};
}

Replay::Replay(std::unique_ptr<mcap::Reader> reader, std::unique_ptr<RecordingReader> items,
               ReplayOptions options)
    : reader_(std::move(reader)), items_(std::move(items)), options_(std::move(options)) {}

Replay::~Replay() = default;

std::vector<std::string> Replay::recorded_processes() const {
  std::set<std::string> names;
  for (const RecordedSource& source : items_->sources()) {
    if (source.count > 0) names.insert(source.name.process);
  }
  return {names.begin(), names.end()};
}

std::string Replay::NameOf(const std::string& recorded) const {
  return options_.as.empty() ? recorded : options_.as;
}

std::vector<std::string> Replay::processes() const {
  std::vector<std::string> names = recorded_processes();
  for (std::string& name : names) name = NameOf(name);
  return names;
}

Result<void> Replay::Start(const MakeProcess& make) {
  const auto refuse = [this](const Error& error) {
    processes_.clear();
    return error;
  };
  members_.resize(items_->sources().size());
  try {
    for (const std::string& recorded : recorded_processes()) {
      auto process = make(NameOf(recorded));
      if (!process) return refuse(process.error());
      Process& made = **process;
      processes_[recorded] = *std::move(process);
      if (const auto added = AddComponents(recorded, made); !added) return refuse(added.error());
    }
  } catch (const ConfigurationError& error) {
    return refuse({error.code(), reader_->name() + " cannot be replayed: " + error.what()});
  } catch (const std::exception& thrown) {
    return refuse({ErrorCode::kFailed, reader_->name() + " cannot be replayed: " + thrown.what()});
  }
  return {};
}

Result<void> Replay::AddComponents(const std::string& recorded, Process& process) {
  std::map<std::string, std::shared_ptr<ReplayedMembers>> components;
  for (std::size_t i = 0; i < items_->sources().size(); ++i) {
    const RecordedSource& source = items_->sources()[i];
    if (source.name.process != recorded || source.count == 0) continue;
    auto& members = components[source.name.component];
    if (!members) members = std::make_shared<ReplayedMembers>();
    if (source.is_table) {
      members->AddTable(i, source, PeriodOf(source));
    } else {
      source.are_commands ? members->AddCommands(i, source) : members->AddEvents(i, source);
    }
    members_[i] = members;
  }
  const std::string mark =
      "replay of " + std::filesystem::path(reader_->name()).filename().string();
  for (const auto& [name, members] : components) {
    const ComponentDescription* description = items_->FindComponent(recorded, name);
    const ReplayedComponent::Options options{
        .description = description, .refusal = "this is a " + mark + "; it executes no commands"};
    process.Add(std::make_unique<ReplayedComponent>(name, members, options),
                {.class_name = description == nullptr ? std::string() : description->class_name,
                 .library = mark});
  }
  return process.StartAll();
}

Result<void> Replay::WaitUntilJoined(std::chrono::milliseconds timeout) const {
  for (const auto& [recorded, process] : processes_) {
    if (auto joined = process->WaitUntilJoined(timeout); !joined) return joined;
  }
  return {};
}

/// The mean time between two rows while they are replayed.
std::chrono::nanoseconds Replay::PeriodOf(const RecordedSource& source) const {
  const auto span = static_cast<double>(source.last_time - source.first_time);
  const auto steps = static_cast<double>(std::max<std::uint64_t>(2, source.count) - 1);
  constexpr double kHour = 3.6e12;  // ns; a longer period does not make the table shorter
  return std::chrono::nanoseconds(
      std::max<std::int64_t>(1, std::llround(std::min(span / steps / options_.rate, kHour))));
}

SteadyTime Replay::DueTime(mcap::Timestamp time) const {
  const auto passed =
      static_cast<double>(static_cast<std::int64_t>(time - items_->counts().first_time));
  return *begin_ + std::chrono::nanoseconds(std::llround(passed / options_.rate));
}

std::optional<SteadyTime> Replay::Play(SteadyTime now) {
  constexpr int kMax = 1000;
  if (!begin_) begin_ = now + options_.delay;
  for (int i = 0; i < kMax; ++i) {
    if (!next_) next_ = items_->Next();
    if (!next_) {
      ++status_.passes;
      if (!options_.loops) return std::nullopt;
      begin_ = DueTime(last_time_) + kBetweenPasses;
      items_->Rewind();
      next_ = items_->Next();
      if (!next_) return std::nullopt;  // the file has become unreadable
    }
    const SteadyTime due = DueTime(next_->time);
    if (due > now) return due;
    if (now - due > kMaxLate) {
      status_.extended += now - due;
      *begin_ += now - due;
    }
    last_time_ = next_->time;
    Put(*next_);
    next_.reset();
  }
  return now;
}

bool Replay::HasSentAll() const {
  return std::ranges::all_of(processes_, [](const auto& one) { return one.second->HasSentAll(); });
}

void Replay::Put(const RecordedItem& item) {
  if (const auto* record = std::get_if<RosLog>(&item.content)) return PutLog(*record);
  ReplayedMembers& members = *members_[item.source];
  if (const auto* row = std::get_if<RecordedRow>(&item.content)) {
    members.Write(item.source, *row, DueTime(item.time));
    ++status_.rows;
    return;
  }
  members.Raise(item.source, std::get<RecordedEvent>(item.content));
  ++(items_->sources()[item.source].are_commands ? status_.commands : status_.events);
}

void Replay::PutLog(const RosLog& record) {
  const std::string_view name = record.name;
  const std::size_t slash = name.find('/');
  const auto process = processes_.find(std::string(name.substr(0, slash)));
  if (process == processes_.end()) {
    ++status_.log_left_out;
    return;
  }
  const std::string source =
      slash == name.npos ? process->second->name() : std::string(name.substr(slash + 1));
  process->second->ForwardLog(LogLevelOf(record.level), source, record.msg);
  ++status_.log;
}

}  // namespace tendon::recording
