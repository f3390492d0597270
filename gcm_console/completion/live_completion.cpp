#include <gcm_console/completion/live_completion.h>

#include <gcm_console/command_line/argument_words.h>
#include <tendon/base/path.h>
#include <tendon/gcm/lifecycle/parameters.h>
#include <tendon/gcm/lookup.h>

#include <algorithm>
#include <set>
#include <utility>

namespace console {
namespace {

using tendon::ClassDescription;
using tendon::GcmClient;
using tendon::Schema;
using tendon::message::Classes;
using Clock = std::chrono::steady_clock;

/// After this time, a reply is requested again.
constexpr std::chrono::seconds kFresh(2);

/// Returns an earlier reply at once if there is one. Otherwise waits for the reply until
/// `deadline`; returns null if none arrives. `start` sends the request; it is called with a handler
/// for the reply.
template <typename T, typename Start>
const T* Ask(CachedReply<T>& cached, std::uint64_t instance, Clock::time_point deadline,
             Start start) {
  const auto now = Clock::now();
  if (cached.instance != instance) cached = {.instance = instance, .since = now - kFresh};
  if (!cached.reply.valid() && now - cached.since >= kFresh) {
    const auto reply = std::make_shared<std::promise<tendon::Result<T>>>();
    cached.reply = reply->get_future();
    cached.since = now;
    start([reply](tendon::Result<T> result) { reply->set_value(std::move(result)); });
  }
  if (cached.reply.valid()) {
    const auto until = cached.known ? now : deadline;
    if (cached.reply.wait_until(until) == std::future_status::ready) {
      if (auto result = cached.reply.get()) cached.known = *std::move(result);
    }
  }
  return cached.known ? &*cached.known : nullptr;
}

const ClassDescription* FindClass(const Classes& all, const tendon::ComponentDescription& of) {
  const auto found = std::ranges::find_if(all.classes, [&](const ClassDescription& one) {
    return one.name == of.class_name && one.library == of.library;
  });
  return found == all.classes.end() ? nullptr : &*found;
}

/// Returns the type of a field of a configuration, such as "gain.x"; empty if the field does not
/// exist.
std::optional<Schema> TypeOf(const ClassDescription& of, const std::string& parameter) {
  const auto whole = Schema::Parse(of.configuration);
  if (!whole) return std::nullopt;
  Schema part = *whole;
  for (std::size_t begin = 0; begin <= parameter.size();) {
    const std::size_t end = std::min(parameter.find('.', begin), parameter.size());
    const std::string name = parameter.substr(begin, end - begin);
    const auto& fields = part.fields();
    const auto field = std::ranges::find(fields, name, &Schema::Field::name);
    if (field == fields.end()) return std::nullopt;
    part = Schema(field->schema);
    begin = end + 1;
  }
  return part;
}

/// Returns the names of all values of the parameter; if the values have no names, its present
/// value.
std::vector<std::string> ValuesFor(const ClassDescription& of, const std::string& configuration,
                                   const std::string& parameter) {
  const auto type = TypeOf(of, parameter);
  if (type) {
    if (auto names = ValuesOf(*type); !names.empty()) return names;
  }
  const auto now = ParametersAt(of, configuration, parameter);
  if (!now || now->size() != 1) return {};
  return {now->front().value};
}

}  // namespace

std::vector<std::string> LiveCompletion::Of(GcmClient& client, WordKind kind,
                                            const std::vector<std::string>& before) {
  deadline_ = Clock::now() + timeout_;
  switch (kind) {
    case WordKind::kClass:
    case WordKind::kPlugIn:
      return OfAllProcesses(client, kind);
    case WordKind::kParameter:
    case WordKind::kSetting:
      return OfComponent(client, kind, before);
    case WordKind::kArgument:
      return OfCommand(client, before);
    default:
      return {};
  }
}

const Classes* LiveCompletion::ClassesOf(GcmClient& client, const std::string& process) {
  const std::uint64_t instance = InstanceOf(client.catalogue(), process);
  return Ask(classes_[process], instance, deadline_,
             [&](auto handler) { client.GetClasses(process, std::move(handler)); });
}

std::vector<std::string> LiveCompletion::OfAllProcesses(GcmClient& client, WordKind kind) {
  std::set<std::string> all;
  const tendon::Catalogue catalogue = client.catalogue();
  for (const auto& [name, entry] : catalogue.processes()) {
    const Classes* known = IsPresent(entry.process) ? ClassesOf(client, name) : nullptr;
    if (known == nullptr) continue;
    if (kind == WordKind::kPlugIn) all.insert(known->plugins.begin(), known->plugins.end());
    if (kind != WordKind::kClass) continue;
    for (const ClassDescription& one : known->classes) all.insert(one.name);
  }
  return {all.begin(), all.end()};
}

std::vector<std::string> LiveCompletion::OfComponent(GcmClient& client, WordKind kind,
                                                     const std::vector<std::string>& before) {
  if (before.empty()) return {};
  const auto path = tendon::ParsePath(before[0]);
  if (!path || path->component.empty()) return {};
  const tendon::Catalogue catalogue = client.catalogue();
  const auto component = LookUpComponent(catalogue, path->process, path->component);
  if (!component) return {};
  const Classes* known = ClassesOf(client, path->process);
  const ClassDescription* of = known == nullptr ? nullptr : FindClass(*known, **component);
  if (of == nullptr) return {};
  const std::string& configuration = (*component)->configuration;
  if (kind == WordKind::kSetting) {
    return before.size() < 2 ? std::vector<std::string>()
                             : ValuesFor(*of, configuration, before[1]);
  }
  std::vector<std::string> names;
  const auto parameters = ParametersOf(*of, configuration);
  if (!parameters) return {};
  for (const tendon::Parameter& one : *parameters) names.push_back(one.name);
  return names;
}

std::vector<std::string> LiveCompletion::OfCommand(GcmClient& client,
                                                   const std::vector<std::string>& before) {
  if (before.empty()) return {};
  const auto path = tendon::ParsePath(before[0]);
  if (!path) return {};
  const tendon::Catalogue catalogue = client.catalogue();
  const auto command = LookUpCommand(catalogue, *path);
  if (!command || !TakesArgument(command->signature)) return {};
  const tendon::Fingerprint type = command->signature.in;
  const Schema* schema =
      Ask(schemas_[type], InstanceOf(catalogue, path->process), deadline_,
          [&](auto handler) { client.GetSchema(path->process, type, std::move(handler)); });
  if (schema == nullptr) return {};
  return NextWords(*schema, {before.begin() + 1, before.end()});
}

}  // namespace console
