#include <tendon/gcm/system_file.h>

#include <tendon/base/os/file.h>
#include <tendon/base/text.h>
#include <tendon/gcm/system/file_object.h>
#include <tendon/gcm/system/leaders.h>
#include <tendon/gcm/system/system_index.h>
#include <tendon/payload/json.h>
#include <tendon/payload/json/strict_json.h>
#include <tendon/task/thread_setup.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <utility>

namespace tendon {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

Error Refused(const fs::path& path, const std::string& reason) {
  return {ErrorCode::kInvalid, path.string() + ": " + reason};
}

/// Reads at most kMaxSize bytes of the file, plus one byte. With this byte, the caller can see that
/// a file is too large.
Result<std::string> ReadBytes(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text(SystemFile::kMaxSize + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad() || (stream.fail() && !stream.eof())) return Refused(path, "cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

void AddComment(OrderedJson& json, const std::string& comment) {
  if (!comment.empty()) json["comment"] = comment;
}

/// Returns the state to write into the file for a component that is now in `state`. A faulted
/// component should become active again. A ready component becomes constructed.
ComponentState DesiredFor(ComponentState state) {
  if (state == ComponentState::kFaulted) return ComponentState::kActive;
  if (state == ComponentState::kReady) return ComponentState::kConstructed;
  return state;
}

/// Writes the policy and the fields that differ from the defaults.
OrderedJson JsonOf(const ThreadOptions& thread) {
  const OrderedJson all = OrderedJson::parse(ToJson(thread));
  const OrderedJson defaults = OrderedJson::parse(ToJson(ThreadOptions()));
  OrderedJson json;
  for (const auto& [key, value] : all.items()) {
    if (key == "policy" || value != defaults.at(key)) json[key] = value;
  }
  return json;
}

OrderedJson JsonOf(const SystemFile::Component& component) {
  OrderedJson json;
  json["name"] = component.name;
  json["class"] = component.class_name;
  if (component.class_name.empty()) json["class"] = nullptr;
  if (!component.library.empty()) json["library"] = component.library;
  if (!component.configuration.empty()) {
    json["configuration"] = OrderedJson::parse(component.configuration);
  }
  if (component.period > 0.0) json["period"] = component.period;
  if (component.thread) json["thread"] = JsonOf(*component.thread);
  if (!component.runs_after.empty()) json["runs_after"] = component.runs_after;
  const ComponentState desired = DesiredFor(component.state);
  if (desired != ComponentState::kActive) json["state"] = ToString(desired);
  AddComment(json, component.comment);
  return json;
}

OrderedJson JsonOf(const SystemFile::Process& process) {
  OrderedJson components = OrderedJson::array();
  for (const auto& component : process.components) components.push_back(JsonOf(component));
  OrderedJson json = {{"name", process.name}, {"components", std::move(components)}};
  if (process.start) json["start"] = {{"restart", ToString(process.start->restart)}};
  AddComment(json, process.comment);
  return json;
}

OrderedJson JsonOf(const SystemFile::Connection& connection) {
  OrderedJson json = {{"required", ToString(connection.required)},
                      {"provided", ToString(connection.provided)}};
  AddComment(json, connection.comment);
  return json;
}

OrderedJson JsonOf(const SystemFile& system) {
  OrderedJson json;
  json["version"] = SystemFile::kVersion;
  json["name"] = system.name;
  if (system.strict) json["strict"] = true;
  AddComment(json, system.comment);
  json["processes"] = OrderedJson::array();
  for (const auto& process : system.processes) json["processes"].push_back(JsonOf(process));
  json["connections"] = OrderedJson::array();
  for (const auto& connection : system.connections) {
    json["connections"].push_back(JsonOf(connection));
  }
  for (const auto& [path, position] : system.layout) {
    json["layout"][path] = OrderedJson::array({position.x, position.y});
  }
  return json;
}

/// Checks that the configurations are JSON and not nested too deeply. Must be called first, because
/// the other functions are recursive.
Result<void> CheckConfigurations(const SystemFile& system) {
  for (const auto& process : system.processes) {
    for (const auto& component : process.components) {
      if (component.configuration.empty()) continue;
      if (const auto parsed = ParseStrictJson(component.configuration); !parsed) {
        return Error{ErrorCode::kInvalid, "the configuration of " + process.name + "/" +
                                              component.name + ": " + parsed.error().message};
      }
    }
  }
  return {};
}

using file::FileObject;
using file::Refuse;
using file::Shown;

/// Reads "thread". Fields that are not in the file keep their defaults.
std::optional<ThreadOptions> ReadThread(const FileObject& object, const std::string& task) {
  const Json* given = object.Find("thread");
  if (given == nullptr) return std::nullopt;
  const std::string place = object.Place("thread");
  Json merged = Json::parse(ToJson(ThreadOptions()));
  std::vector<std::string> keys;
  for (const auto& [key, value] : merged.items()) keys.push_back(key);
  const FileObject known(*given, place, keys);
  merged.update(*given);
  const auto options = FromJson<ThreadOptions>(merged.dump());
  if (!options) Refuse(place, options.error().message);
  try {
    CheckThreadRanges(*options, task);  // the file may be for another machine
  } catch (const ConfigurationError& mistake) {
    Refuse(place, mistake.what());
  }
  return *options;
}

/// Reads a name and returns the value in `known` that has this name.
template <typename T, std::size_t kCount>
T ReadWord(const FileObject& object, const std::string& key, const std::array<T, kCount>& known) {
  const std::string text = object.Text(key);
  std::vector<std::string> names;
  std::string all;
  for (const T one : known) {
    if (ToString(one) == text) return one;
    names.emplace_back(ToString(one));
    all += (all.empty() ? "" : ", ") + names.back();
  }
  const std::string shown = Printable(text, 64);
  Refuse(object.Place(key),
         "expected one of " + all + ", got '" + shown + "'" + DidYouMean(shown, names));
}

/// Reads a state that can be requested for a component.
ComponentState ReadState(const FileObject& object) {
  if (object.Find("state") == nullptr) return ComponentState::kActive;
  return ReadWord(object, "state", SystemFile::kDesirable);
}

/// Reads the class. Returns an empty text for null, which means that the program of the process
/// creates the component itself.
std::string ReadClass(const FileObject& object) {
  if (object.Get("class").is_null()) {
    for (const char* key : {"library", "configuration", "thread", "runs_after"}) {
      if (object.Find(key) == nullptr) continue;
      Refuse(object.Place(key),
             "a component without a class is created by the program of the process, and only that "
             "program can set this value");
    }
    return {};
  }
  return file::ReadClassName(object, "class");
}

SystemFile::Component ReadComponent(const Json& json, const std::string& place) {
  const FileObject object(json, place,
                          {"name", "class", "library", "configuration", "period", "thread",
                           "runs_after", "state", "comment"});
  SystemFile::Component component;
  component.name = object.Name("name", "component");
  component.class_name = ReadClass(object);
  if (object.Find("library") != nullptr) {
    component.library = object.Text("library");
    file::CheckLibrary(component.library, object.Place("library"));
  }
  if (const Json* configuration = object.Find("configuration")) {
    component.configuration =
        file::ConfigurationText(*configuration, object.Place("configuration"));
  }
  component.period = object.Period("period");
  component.thread = ReadThread(object, component.name);
  if (object.Find("runs_after") != nullptr) {
    component.runs_after = object.Name("runs_after", "component");
  }
  component.state = ReadState(object);
  component.comment = object.Comment();
  return component;
}

/// Checks that each leader is another component of the process, and that there are no cycles.
void CheckLeaders(const std::vector<SystemFile::Component>& components, const FileObject& process) {
  std::vector<std::string> names;
  for (const auto& one : components) names.push_back(one.name);
  const std::set<std::string> known(names.begin(), names.end());
  for (std::size_t i = 0; i < components.size(); ++i) {
    const std::string& leader = components[i].runs_after;
    if (leader.empty() || known.contains(leader)) continue;
    Refuse(process.Place("components") + "[" + std::to_string(i) + "].runs_after",
           "the process has no component '" + leader + "'" + DidYouMean(leader, names));
  }
  if (const std::string cycle = FindCycle(components); !cycle.empty()) {
    Refuse(process.Place("components"), "runs_after forms a cycle: " + cycle);
  }
}

/// Reads "start". Only a process that the GCM starts as an `lcm` has this key.
SystemFile::Start ReadStart(const Json& json, const FileObject& process) {
  const FileObject object(json, process.Place("start"), {"restart"});
  if (object.Find("restart") == nullptr) return {};
  return {ReadWord(object, "restart", kRestartPolicies)};
}

SystemFile::Process ReadProcess(const Json& json, const std::string& place) {
  const FileObject object(json, place, {"name", "components", "start", "comment"});
  SystemFile::Process process;
  process.name = object.Name("name", "process");
  object.Require("components");
  file::UniqueNames names("component");
  object.ForEach("components", [&](const Json& element, const std::string& at) {
    process.components.push_back(ReadComponent(element, at));
    names.Add(process.components.back().name, at + ".name");
  });
  CheckLeaders(process.components, object);
  if (const Json* start = object.Find("start")) process.start = ReadStart(*start, object);
  const auto is_made_by_its_program = [](const auto& one) { return one.class_name.empty(); };
  if (process.start && std::ranges::any_of(process.components, is_made_by_its_program)) {
    Refuse(object.Place("start"),
           "the GCM starts this process as an lcm, but an lcm cannot create a component without a "
           "class: remove \"start\", or give each component a class");
  }
  process.comment = object.Comment();
  return process;
}

/// Reads the parts of the file that refer to its processes.
class LinkReader {
 public:
  explicit LinkReader(SystemFile& system) : system_(system) {}

  void ReadConnection(const Json& json, const std::string& place) {
    const FileObject object(json, place, {"required", "provided", "comment"});
    const SystemFile::Connection connection{object.Interface("required"),
                                            object.Interface("provided"), object.Comment()};
    const auto& [required, provided, comment] = connection;
    CheckComponent(required.process, required.component, object.Place("required"));
    CheckComponent(provided.process, provided.component, object.Place("provided"));
    const auto [other, is_new] = connected_.emplace(required, provided);
    if (!is_new) {
      Refuse(object.Place("required"),
             ToString(required) + " is connected to " + ToString(other->second) + " already");
    }
    system_.connections.push_back(connection);
  }

  void ReadLayout(const FileObject& object) {
    const Json* layout = object.Find("layout");
    if (layout == nullptr) return;
    if (!layout->is_object()) Refuse("layout", "expected an object, got " + Shown(*layout));
    for (const auto& [path, value] : layout->items()) ReadPosition(path, value);
  }

 private:
  /// Checks that the component is in the file. Its interface cannot be checked here, because the
  /// component may not exist yet.
  void CheckComponent(const std::string& process, const std::string& component,
                      const std::string& place) const {
    if (index_.FindComponent(process, component) != nullptr) return;
    std::vector<std::string> names;
    const auto* found = index_.FindProcess(process);
    if (found == nullptr) {
      for (const auto& one : system_.processes) names.push_back(one.name);
      Refuse(place, "the file has no process '" + process + "'" + DidYouMean(process, names));
    }
    for (const auto& one : found->components) names.push_back(one.name);
    Refuse(place, "the file has no component '" + process + "/" + component + "'" +
                      DidYouMean(component, names));
  }

  /// "process/component": [x, y]
  void ReadPosition(const std::string& path, const Json& value) {
    const std::string shown = Printable(path, 140);
    const std::string place = "layout." + shown;
    const std::size_t slash = path.find('/');
    if (slash == path.npos) {
      Refuse(place, "'" + shown + "' is not a component: expected process/component");
    }
    CheckComponent(Printable(path.substr(0, slash), 64), Printable(path.substr(slash + 1), 64),
                   place);
    const bool is_pair =
        value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
    if (!is_pair) Refuse(place, "expected [x, y], got " + Shown(value));
    system_.layout[path] = {value[0].get<double>(), value[1].get<double>()};
  }

  SystemFile& system_;
  const SystemIndex index_{system_};
  std::map<InterfaceName, InterfaceName> connected_;
};

void CheckVersion(const Json& json) {
  if (!json.is_object() || !json.contains("version")) return;
  const Json& version = json["version"];
  if (!version.is_number_integer()) {
    Refuse("version", "expected " + std::to_string(SystemFile::kVersion) + ", got " +
                          (version.is_number() ? version.dump() : Shown(version)));
  }
  if (version != SystemFile::kVersion) {
    throw file::FileError{"version", "the file has version " + version.dump() +
                                         ", but this program reads version " +
                                         std::to_string(SystemFile::kVersion)};
  }
}

SystemFile ReadSystem(const Json& json) {
  CheckVersion(json);  // first, because another version may have other keys
  const FileObject object(
      json, "", {"version", "name", "strict", "processes", "connections", "layout", "comment"});
  object.Require("version");
  SystemFile system;
  system.name = Printable(object.Text("name"), 256);
  system.strict = object.Flag("strict");
  object.Require("processes");
  file::UniqueNames names("process");
  object.ForEach("processes", [&](const Json& element, const std::string& place) {
    system.processes.push_back(ReadProcess(element, place));
    names.Add(system.processes.back().name, place + ".name");
  });
  LinkReader links(system);
  object.ForEach("connections", [&](const Json& element, const std::string& place) {
    links.ReadConnection(element, place);
  });
  links.ReadLayout(object);
  system.comment = object.Comment();
  return system;
}

}  // namespace

const SystemFile::Process* SystemFile::FindProcess(const std::string& process_name) const {
  return FindNamed(processes, process_name);
}

const SystemFile::Component* SystemFile::FindComponent(const std::string& process_name,
                                                       const std::string& component_name) const {
  const Process* process = FindProcess(process_name);
  return process == nullptr ? nullptr : FindNamed(process->components, component_name);
}

Result<std::string> ReadSystemText(const fs::path& path) {
  if (path.empty())
    return Error{ErrorCode::kInvalid, "no file is given: give the path of a system file"};
  std::error_code reason;
  const fs::file_status status = fs::status(path, reason);
  if (status.type() == fs::file_type::not_found) {
    return Error{ErrorCode::kNotFound, path.string() + ": there is no such file"};
  }
  if (status.type() == fs::file_type::directory) {
    return Refused(path, "is a folder, not a file");
  }
  if (reason) return Refused(path, reason.message());
  if (status.type() != fs::file_type::regular) return Refused(path, "is not a regular file");
  return os::ReadUnchanged(path, [&path] { return ReadBytes(path); });
}

Result<SystemFile> ReadSystemFile(const fs::path& path) {
  const auto text = ReadSystemText(path);
  if (!text) return text.error();
  return ParseSystemFile(*text, path.string());
}

Result<std::string> SystemFileText(const SystemFile& system) {
  const auto refuse = [&](const std::string& why) {
    return Error{ErrorCode::kInvalid,
                 "system " + Quoted(system.name, 256) + " cannot be written as a file: " + why};
  };
  if (const auto checked = CheckConfigurations(system); !checked) {
    return refuse(checked.error().message);
  }
  std::string text;
  try {
    constexpr int kIndent = 2;
    text = JsonOf(system).dump(kIndent) + "\n";
  } catch (const OrderedJson::exception& exception) {  // thrown if a text is not UTF-8
    return refuse(exception.what());
  }
  const auto again = ParseSystemFile(text, "the written text");
  return again ? Result<std::string>(std::move(text)) : refuse(again.error().message);
}

Result<void> WriteSystemFile(const fs::path& path, const SystemFile& system) {
  const auto text = SystemFileText(system);
  if (!text) return text.error();
  return os::ReplaceDurably(path, *text);
}

Result<SystemFile> ParseSystemFile(std::string_view text, const std::string& source) {
  if (text.size() > SystemFile::kMaxSize) {
    return Error{ErrorCode::kInvalid, source + ": the file is larger than 16 MB"};
  }
  return file::ReadText<SystemFile>(text, source, ReadSystem);
}

}  // namespace tendon
