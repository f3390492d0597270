#include <tendon/gcm/step_history.h>

#include <tendon/base/log.h>
#include <tendon/base/os/file.h>
#include <tendon/base/text.h>
#include <tendon/payload/json.h>
#include <tendon/payload/json/strict_json.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <utility>

namespace tendon {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string LineOf(const message::HistoryEntry& step) {
  OrderedJson line;
  line["id"] = step.id;
  line["verb"] = step.verb;
  if (step.lifecycle.process.empty()) {
    line["required"] = ToString(step.ends.required);
    line["provided"] = ToString(step.ends.provided);
  } else {
    line["life"] = OrderedJson::parse(ToJson(step.lifecycle));
  }
  if (step.verb == "replace") line["former"] = ToString(step.former);
  line["who"] = step.who;
  line["when"] = step.when;
  line["instance"] = step.instance;
  if (step.is_unknown) line["unknown"] = true;
  if (step.undone) line["undone"] = true;
  if (step.passed_over) line["passed over"] = true;
  return line.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

/// Throws OrderedJson::exception if the line is not a step.
std::optional<message::HistoryEntry> EntryOf(const OrderedJson& line) {
  message::HistoryEntry step;
  step.id = line.at("id").get<std::uint64_t>();
  step.verb = line.at("verb").get<std::string>();
  if (line.contains("life")) {
    auto lifecycle = FromJson<message::LifecycleStep>(line.at("life").dump());
    if (!lifecycle) return std::nullopt;
    step.lifecycle = *std::move(lifecycle);
  } else {
    const auto required = ParseInterfaceName(line.at("required").get<std::string>());
    const auto provided = ParseInterfaceName(line.at("provided").get<std::string>());
    if (!required || !provided) return std::nullopt;
    step.ends = {*required, *provided};
  }
  if (step.verb == "replace") {
    const auto former = ParseInterfaceName(line.at("former").get<std::string>());
    if (!former) return std::nullopt;
    step.former = *former;
  }
  step.who = line.at("who").get<std::string>();
  step.when = line.at("when").get<std::int64_t>();
  step.instance = line.value("instance", std::uint64_t{0});
  step.is_unknown = line.value("unknown", false);
  step.undone = line.value("undone", false);
  step.passed_over = line.value("passed over", false);
  return step;
}

// The keys of lines that mark an earlier step as undone or skipped.
constexpr const char* kUndo = "undo";
constexpr const char* kPassOver = "pass over";

using Undos = std::map<std::uint64_t, UndoMark>;

std::string MarkLine(std::uint64_t id, const char* what, const UndoMark& by) {
  OrderedJson line = {{what, id}};
  if (!by.who.empty()) {
    line["who"] = by.who;
    line["when"] = by.when;
  }
  return line.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

/// Marks a step; returns false if there is no such step.
bool MarkIn(std::vector<message::HistoryEntry>& steps, std::uint64_t id, std::string_view what) {
  bool is_known = false;
  for (message::HistoryEntry& step : steps) {
    if (step.id != id) continue;
    (what == kUndo ? step.undone : step.passed_over) = true;
    is_known = true;
  }
  return is_known;
}

/// Adds one line of the file; returns false if it is invalid.
bool ReadLine(std::string_view text, std::vector<message::HistoryEntry>& steps, Undos& undos) {
  try {
    const auto parsed = ParseOrderedJson(text);
    if (!parsed) return false;
    const OrderedJson& line = *parsed;
    for (const char* mark : {kUndo, kPassOver}) {
      if (!line.contains(mark)) continue;
      const auto id = line.at(mark).get<std::uint64_t>();
      const bool is_known = MarkIn(steps, id, mark);
      if (line.contains("who")) {
        UndoMark by{line.at("who").get<std::string>(), line.at("when").get<std::int64_t>()};
        if (is_known) undos[id] = std::move(by);
      }
      return true;
    }
    auto step = EntryOf(line);
    if (step) steps.push_back(std::move(*step));
    return step.has_value();
  } catch (const OrderedJson::exception&) {
    return false;
  }
}

}  // namespace

std::string ToString(const message::HistoryEntry& step) {
  if (!step.lifecycle.process.empty()) {
    const std::string component =
        step.lifecycle.component.empty() ? "" : "/" + step.lifecycle.component;
    return step.verb + " " + step.lifecycle.process + component;
  }
  return step.verb + " " + ToString(step.ends.required) + " " + ToString(step.ends.provided);
}

StepHistory::StepHistory(std::filesystem::path file) : file_(std::move(file)) {
  Load();
  writer_.Post([this] { Probe(); });
}

StepHistory::~StepHistory() { Close(); }

void StepHistory::Probe() const {
  const auto writable = os::CheckWritable(file_);
  if (writable) return;
  Log(LogLevel::kWarning, "gcm",
      "the history is not saved: " + writable.error().message +
          "; steps can be undone only until this GCM ends; make the folder writable, "
          "or choose another folder with XDG_STATE_HOME");
}

void StepHistory::Load() {
  std::ifstream stream(file_, std::ios::binary);
  if (!stream) return;
  std::stringstream content;
  content << stream.rdbuf();
  const std::string text = content.str();
  std::size_t unreadable = 0;
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != text.npos; end = text.find('\n', begin)) {
    const auto line = std::string_view(text).substr(begin, end - begin);
    if (!ReadLine(line, steps_, undos_)) ++unreadable;
    begin = end + 1;
  }
  if (unreadable > 0) {
    Log(LogLevel::kWarning, "gcm",
        Counted(unreadable, "line", "lines") + " of " + file_.string() +
            " cannot be read and are left out");
  }
  const std::size_t read = steps_.size();
  for (auto& step : std::exchange(steps_, {})) {
    last_id_ = std::max(last_id_, step.id);
    const std::size_t bytes = LineOf(step).size();
    Keep(std::move(step), bytes);
  }
  file_bytes_ = text.size();
  const bool is_kept_whole = begin == text.size() && unreadable == 0 && steps_.size() == read;
  if (!is_kept_whole) is_torn_ = !Replace(Text()) && begin < text.size();
}

void StepHistory::Keep(message::HistoryEntry step, std::size_t bytes) {
  steps_.push_back(std::move(step));
  bytes_.push_back(bytes);
  all_bytes_ += bytes;
  std::size_t gone = 0;
  for (; steps_.size() - gone > 1; ++gone) {
    if (steps_.size() - gone <= kMaxSteps && all_bytes_ <= kMaxBytes) break;
    all_bytes_ -= bytes_.front();
    bytes_.pop_front();
    undos_.erase(steps_[gone].id);
  }
  steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(gone));
}

std::string StepHistory::Text() const {
  std::string text;
  for (const auto& step : steps_) {
    text += LineOf(step);
    const auto undo = undos_.find(step.id);
    if (undo != undos_.end()) text += MarkLine(step.id, kUndo, undo->second);
  }
  return text;
}

bool StepHistory::Replace(const std::string& text) {
  const auto replaced = os::ReplaceDurably(file_, text);
  if (!replaced) Log(LogLevel::kWarning, "gcm", replaced.error().message);
  if (replaced) file_bytes_ = text.size();
  return replaced.ok();
}

bool StepHistory::Append(const std::vector<Line>& lines) {
  std::string text = is_torn_ ? "\n" : "";
  for (const Line& line : lines) text += line.text;
  const auto written = os::AppendDurably(file_, text);
  if (!written) Log(LogLevel::kWarning, "gcm", "history: " + written.error().message);
  file_bytes_ += text.size();
  return written.ok();
}

std::uint64_t StepHistory::Record(message::HistoryEntry step, Done done) {
  const std::scoped_lock lock(mutex_);
  step.id = ++last_id_;
  unwritten_.push_back({LineOf(step), std::move(done)});
  Keep(std::move(step), unwritten_.back().text.size());
  writer_.Post([this] { Write(); });
  return last_id_;
}

void StepHistory::MarkUndone(std::uint64_t id, Done done, const UndoMark& by) {
  Mark(id, kUndo, std::move(done), by);
}

void StepHistory::MarkPassedOver(std::uint64_t id, Done done) {
  Mark(id, kPassOver, std::move(done));
}

void StepHistory::Mark(std::uint64_t id, const char* what, Done done, const UndoMark& by) {
  const std::scoped_lock lock(mutex_);
  if (MarkIn(steps_, id, what) && !by.who.empty()) undos_[id] = by;
  unwritten_.push_back({MarkLine(id, what, by), std::move(done)});
  writer_.Post([this] { Write(); });
}

void StepHistory::Close() {
  writer_.Stop();
  Write();
}

/// Writes all pending lines with one access to the disk, because the disk may be slow.
void StepHistory::Write() {
  const bool is_long = file_bytes_ > 2 * kMaxBytes;
  std::vector<Line> lines;
  std::string all;
  {
    const std::scoped_lock lock(mutex_);
    lines.swap(unwritten_);
    if (is_long) all = Text();
  }
  if (lines.empty()) return;
  is_torn_ = !(is_long && Replace(all)) && !Append(lines);
  for (const Line& line : lines) line.done();
}

message::History StepHistory::steps() const {
  const std::scoped_lock lock(mutex_);
  return {steps_};
}

UndoMark StepHistory::undo_of(std::uint64_t id) const {
  const std::scoped_lock lock(mutex_);
  const auto found = undos_.find(id);
  return found == undos_.end() ? UndoMark() : found->second;
}

std::optional<message::HistoryEntry> StepHistory::last() const {
  const std::scoped_lock lock(mutex_);
  const auto found = std::find_if(steps_.rbegin(), steps_.rend(), [](const auto& step) {
    return !step.undone && !step.passed_over;
  });
  return found == steps_.rend() ? std::nullopt : std::optional(*found);
}

}  // namespace tendon
