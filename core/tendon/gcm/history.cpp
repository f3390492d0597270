#include <tendon/base/log.h>
#include <tendon/base/os/file.h>
#include <tendon/gcm/history.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <utility>

namespace tendon {
namespace {

using Json = nlohmann::ordered_json;

std::string LineOf(const message::HistoryEntry& step) {
  Json line;
  line["id"] = step.id;
  line["verb"] = step.verb;
  line["required"] = ToString(step.wire.required);
  line["provided"] = ToString(step.wire.provided);
  if (step.verb == "replace") line["former"] = ToString(step.former);
  line["who"] = step.who;
  line["when"] = step.when;
  if (step.undone) line["undone"] = true;
  return line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Throws Json::exception where it is not such a line.
std::optional<message::HistoryEntry> StepOf(const Json& line) {
  message::HistoryEntry step;
  step.id = line.at("id").get<std::uint64_t>();
  step.verb = line.at("verb").get<std::string>();
  const auto required = ParseInterfaceName(line.at("required").get<std::string>());
  const auto provided = ParseInterfaceName(line.at("provided").get<std::string>());
  if (!required || !provided) return std::nullopt;
  step.wire = {*required, *provided};
  if (step.verb == "replace") {
    const auto former = ParseInterfaceName(line.at("former").get<std::string>());
    if (!former) return std::nullopt;
    step.former = *former;
  }
  step.who = line.at("who").get<std::string>();
  step.when = line.at("when").get<std::int64_t>();
  step.undone = line.value("undone", false);
  return step;
}

void MarkIn(std::vector<message::HistoryEntry>& steps, std::uint64_t id) {
  for (message::HistoryEntry& step : steps) {
    if (step.id == id) step.undone = true;
  }
}

/// Adds the line to what is known; false where it does not read.
bool ReadLine(std::string_view text, std::vector<message::HistoryEntry>& steps) {
  try {
    const Json line = Json::parse(text);
    if (line.contains("undo")) {
      MarkIn(steps, line.at("undo").get<std::uint64_t>());
      return true;
    }
    auto step = StepOf(line);
    if (step) steps.push_back(std::move(*step));
    return step.has_value();
  } catch (const Json::exception&) {
    return false;
  }
}

}  // namespace

History::History(std::filesystem::path file) : file_(std::move(file)) { Load(); }

History::~History() { Close(); }

void History::Load() {
  std::ifstream stream(file_, std::ios::binary);
  if (!stream) return;
  std::stringstream content;
  content << stream.rdbuf();
  const std::string text = content.str();
  std::size_t unreadable = 0;
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != text.npos; end = text.find('\n', begin)) {
    if (!ReadLine(std::string_view(text).substr(begin, end - begin), steps_)) ++unreadable;
    begin = end + 1;
  }
  if (unreadable > 0) {
    Log(LogLevel::kWarning, "gcm",
        std::to_string(unreadable) + " lines of " + file_.string() + " do not read: left out");
  }
  for (const auto& step : steps_) last_id_ = std::max(last_id_, step.id);
  if (begin < text.size() || unreadable > 0 || steps_.size() > kMaxSteps) Compact();
}

void History::Compact() {
  if (steps_.size() > kMaxSteps) {
    steps_.erase(steps_.begin(), steps_.end() - static_cast<std::ptrdiff_t>(kMaxSteps));
  }
  std::string text;
  for (const auto& step : steps_) text += LineOf(step);
  if (const auto replaced = os::ReplaceDurably(file_, text); !replaced) {
    Log(LogLevel::kWarning, "gcm", replaced.error().message);
  }
}

std::uint64_t History::Record(message::HistoryEntry step, Done done) {
  const std::scoped_lock lock(mutex_);
  step.id = ++last_id_;
  steps_.push_back(step);
  if (steps_.size() > kMaxSteps) steps_.erase(steps_.begin());
  unwritten_.push_back({LineOf(step), std::move(done)});
  writer_.Post([this] { Write(); });
  return step.id;
}

void History::MarkUndone(std::uint64_t id, Done done) {
  const std::scoped_lock lock(mutex_);
  MarkIn(steps_, id);
  unwritten_.push_back({Json{{"undo", id}}.dump() + "\n", std::move(done)});
  writer_.Post([this] { Write(); });
}

void History::Close() {
  writer_.Stop();
  Write();
}

/// All that waits, in one go: a slow disk is waited for once.
void History::Write() {
  std::vector<Line> lines;
  {
    const std::scoped_lock lock(mutex_);
    lines.swap(unwritten_);
  }
  if (lines.empty()) return;
  std::string text = is_torn_ ? "\n" : "";
  for (const Line& line : lines) text += line.text;
  const auto written = os::AppendDurably(file_, text);
  is_torn_ = !written;
  if (!written) Log(LogLevel::kWarning, "gcm", "history: " + written.error().message);
  for (const Line& line : lines) line.done();
}

message::History History::steps() const {
  const std::scoped_lock lock(mutex_);
  return {steps_};
}

std::optional<message::HistoryEntry> History::last() const {
  const std::scoped_lock lock(mutex_);
  const auto found =
      std::find_if(steps_.rbegin(), steps_.rend(), [](const auto& step) { return !step.undone; });
  return found == steps_.rend() ? std::nullopt : std::optional(*found);
}

}  // namespace tendon
