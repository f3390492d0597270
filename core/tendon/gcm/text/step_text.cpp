#include <tendon/base/text.h>
#include <tendon/gcm/history.h>
#include <tendon/gcm/text/step_text.h>
#include <tendon/gcm/text/wall_time.h>
#include <tendon/payload/json/strict_json.h>

#include <nlohmann/json.hpp>
#include <set>

namespace tendon {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson ObjectOf(const std::string& configuration) {
  auto object = JsonOrText(configuration);
  return object.is_object() ? object : OrderedJson::object();
}

std::string ValueOf(const OrderedJson& object, const std::string& key) {
  constexpr std::size_t kMost = 80;
  return object.contains(key) ? Printable(object.at(key).dump(), kMost) : "default";
}

}  // namespace

std::string WholeText(const message::HistoryEntry& step) {
  return "step " + std::to_string(step.id) + " (" + ToString(step) + ", by " + step.who + " at " +
         WallTimeText(step.when) + ")";
}

std::string ChangesText(const message::HistoryEntry& step) {
  if (step.verb != ToString(LifeVerb::kConfigure)) return {};
  const OrderedJson former = ObjectOf(step.life.former);
  const OrderedJson now = ObjectOf(step.life.configuration);
  std::set<std::string> keys;
  for (const auto& [key, value] : former.items()) keys.insert(key);
  for (const auto& [key, value] : now.items()) keys.insert(key);
  std::string text;
  for (const std::string& key : keys) {
    const std::string before = ValueOf(former, key);
    const std::string after = ValueOf(now, key);
    if (before == after) continue;
    text += (text.empty() ? "" : ", ") + Printable(key, 64) + " " + before + " -> " + after;
  }
  return text;
}

bool IsOfLife(const message::HistoryEntry& step) { return !step.life.process.empty(); }

bool IsOfProcess(const message::HistoryEntry& step) {
  return IsOfLife(step) && step.life.component.empty();
}

const std::string& ProcessOf(const message::HistoryEntry& step) {
  return IsOfLife(step) ? step.life.process : step.wire.required.process;
}

}  // namespace tendon
