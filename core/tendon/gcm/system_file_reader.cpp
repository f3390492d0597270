#include <tendon/base/printable.h>
#include <tendon/gcm/system_file.h>
#include <tendon/payload/json/strict_json.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace tendon {
namespace {

/// What is wrong, and where; thrown by Reader alone and caught in ParseSystemFile().
struct Mistake {
  std::string text;
};

[[noreturn]] void Refuse(const std::string& place, const std::string& reason) {
  throw Mistake{place.empty() ? reason : place + ": " + reason};
}

std::string Shown(const Json& value) {
  if (!value.is_string()) return KindOf(value);
  return "text '" + Printable(value.get_ref<const std::string&>(), 64) + "'";
}

/// One object of the file with its place: "processes[0]".
class Reader {
 public:
  Reader(const Json& object, std::string place, const std::vector<std::string>& keys)
      : object_(object), place_(std::move(place)) {
    if (!object.is_object()) Refuse(place_, "expected an object, got " + KindOf(object));
    for (const auto& [key, value] : object.items()) {
      if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
      const std::string shown = Printable(key, 64);
      Refuse(place_, "unknown key '" + shown + "'" + DidYouMean(shown, keys));
    }
  }

  [[nodiscard]] std::string Place(const std::string& key) const {
    return place_.empty() ? key : place_ + "." + key;
  }

  [[nodiscard]] const Json* Find(const std::string& key) const {
    const auto found = object_.find(key);
    return found == object_.end() ? nullptr : &*found;
  }

  [[nodiscard]] const Json& Get(const std::string& key) const {
    Require(key);
    return *Find(key);
  }

  void Require(const std::string& key) const {
    if (Find(key) == nullptr) Refuse(place_, "key '" + key + "' is missing");
  }

  [[nodiscard]] std::string Text(const std::string& key) const {
    const Json& value = Get(key);
    if (!value.is_string()) Refuse(Place(key), "expected text, got " + KindOf(value));
    return value.get<std::string>();
  }

  [[nodiscard]] std::string Name(const std::string& key, const std::string& what) const {
    std::string name = Text(key);
    if (auto checked = CheckName(what, name); !checked) Refuse(Place(key), checked.error().message);
    return name;
  }

  [[nodiscard]] InterfaceName Interface(const std::string& key) const {
    auto name = ParseInterfaceName(Text(key));
    if (!name) Refuse(Place(key), name.error().message);
    return *std::move(name);
  }

  /// Calls `read(element, place)` for each; a missing list is empty.
  template <typename Read>
  void ForEach(const std::string& key, Read&& read) const {
    const Json* list = Find(key);
    if (list == nullptr) return;
    if (!list->is_array()) Refuse(Place(key), "expected a list, got " + Shown(*list));
    std::size_t index = 0;
    for (const Json& element : *list)
      read(element, Place(key) + "[" + std::to_string(index++) + "]");
  }

 private:
  const Json& object_;
  const std::string place_;
};

void CheckLibrary(const std::string& library, const std::string& place) {
  const std::string shown = "library '" + Printable(library, 64) + "' ";
  if (library.empty()) Refuse(place, "library name is empty; leave the key out for none");
  if (library.find('/') != library.npos || library.find('\\') != library.npos ||
      library.find("..") != library.npos) {
    Refuse(place,
           shown + "is a path; give the name alone, it is looked for in the plug-in folders");
  }
  if (Printable(library) != library) Refuse(place, shown + "has a character that no name has");
}

SystemFile::Component ReadComponent(const Json& json, const std::string& place) {
  const Reader reader(json, place, {"name", "class", "library", "configuration"});
  SystemFile::Component component;
  component.name = reader.Name("name", "component");
  component.class_name = reader.Text("class");
  if (component.class_name.empty()) Refuse(reader.Place("class"), "class name is empty");
  if (reader.Find("library") != nullptr) {
    component.library = reader.Text("library");
    CheckLibrary(component.library, reader.Place("library"));
  }
  if (const Json* configuration = reader.Find("configuration")) {
    if (!configuration->is_object()) {
      Refuse(reader.Place("configuration"), "expected an object, got " + Shown(*configuration));
    }
    component.configuration = configuration->dump();
  }
  return component;
}

template <typename T>
void RequireNewName(const std::vector<T>& known, const std::string& name, const std::string& place,
                    const std::string& what) {
  const auto same = std::find_if(known.begin(), known.end(),
                                 [&](const T& element) { return element.name == name; });
  if (same != known.end()) Refuse(place + ".name", what + " '" + name + "' is there already");
}

SystemFile::Process ReadProcess(const Json& json, const std::string& place) {
  const Reader reader(json, place, {"name", "components"});
  SystemFile::Process process;
  process.name = reader.Name("name", "process");
  reader.Require("components");
  reader.ForEach("components", [&](const Json& element, const std::string& at) {
    auto component = ReadComponent(element, at);
    RequireNewName(process.components, component.name, at, "component");
    process.components.push_back(std::move(component));
  });
  return process;
}

/// That the file has the component; whether that has the interface is known when it runs.
void CheckEnd(const SystemFile& system, const InterfaceName& end, const std::string& place) {
  std::vector<std::string> names;
  for (const auto& process : system.processes) names.push_back(process.name);
  const SystemFile::Process* process = system.FindProcess(end.process);
  if (process == nullptr) {
    Refuse(place, "the file has no process '" + end.process + "'" + DidYouMean(end.process, names));
  }
  names.clear();
  for (const auto& component : process->components) names.push_back(component.name);
  if (std::find(names.begin(), names.end(), end.component) == names.end()) {
    Refuse(place, "the file has no component '" + end.process + "/" + end.component + "'" +
                      DidYouMean(end.component, names));
  }
}

SystemFile::Connection ReadConnection(const Json& json, const std::string& place,
                                      const SystemFile& system) {
  const Reader reader(json, place, {"required", "provided"});
  SystemFile::Connection connection{reader.Interface("required"), reader.Interface("provided")};
  CheckEnd(system, connection.required, reader.Place("required"));
  CheckEnd(system, connection.provided, reader.Place("provided"));
  for (const auto& other : system.connections) {
    if (other.required != connection.required) continue;
    Refuse(reader.Place("required"),
           ToString(other.required) + " is connected to " + ToString(other.provided) + " already");
  }
  return connection;
}

void CheckVersion(const Json& json) {
  if (!json.is_object() || !json.contains("version")) return;
  const Json& version = json["version"];
  if (!version.is_number_integer()) {
    Refuse("version", "expected " + std::to_string(SystemFile::kVersion) + ", got " +
                          (version.is_number() ? version.dump() : Shown(version)));
  }
  if (version != SystemFile::kVersion) {
    Refuse("", "file is version " + version.dump() + ", this program reads " +
                   std::to_string(SystemFile::kVersion));
  }
}

SystemFile ReadSystem(const Json& json) {
  CheckVersion(json);  // first: another version may have other keys
  const Reader reader(json, "", {"version", "name", "processes", "connections"});
  reader.Require("version");
  SystemFile system;
  system.name = Printable(reader.Text("name"), 256);
  reader.Require("processes");
  reader.ForEach("processes", [&](const Json& element, const std::string& place) {
    auto process = ReadProcess(element, place);
    RequireNewName(system.processes, process.name, place, "process");
    system.processes.push_back(std::move(process));
  });
  reader.ForEach("connections", [&](const Json& element, const std::string& place) {
    system.connections.push_back(ReadConnection(element, place, system));
  });
  return system;
}

}  // namespace

Result<SystemFile> ParseSystemFile(std::string_view text, const std::string& source) {
  if (text.size() > SystemFile::kMaxSize) {
    return Error{ErrorCode::kInvalid, source + ": is larger than 16 MB"};
  }
  const auto json = ParseStrictJson(text);
  if (!json) return Error{ErrorCode::kInvalid, source + ": " + json.error().message};
  try {
    return ReadSystem(*json);
  } catch (const Mistake& mistake) {
    return Error{ErrorCode::kInvalid, source + ": " + mistake.text};
  }
}

}  // namespace tendon
