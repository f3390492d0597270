#include <tendon/gcm/system/component_manager_file.h>

#include <tendon/base/text.h>
#include <tendon/gcm/system/file_object.h>
#include <tendon/gcm/system/system_index.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace tendon {
namespace {

using file::FileObject;
using file::Refuse;

/// Returns the position after the string that begins at `begin`.
std::size_t EndOfString(std::string_view text, std::size_t begin) {
  std::size_t at = begin + 1;
  while (at < text.size() && text[at] != '"') at += text[at] == '\\' ? 2 : 1;
  return at + 1;
}

/// Returns the position after the comment that begins at `begin`. Returns `begin` if there is no
/// complete comment.
std::size_t EndOfComment(std::string_view text, std::size_t begin) {
  const std::string_view sign = text.substr(begin, 2);
  if (sign == "//") return std::min(text.find('\n', begin), text.size());
  const std::size_t end = sign == "/*" ? text.find("*/", begin + 2) : text.npos;
  return end == text.npos ? begin : end + 2;
}

/// Returns the text with comments replaced by blanks, so that lines and columns do not change. Only
/// this file format allows comments.
std::string WithoutComments(std::string_view text) {
  std::string plain(text);
  std::size_t at = plain.find_first_of("\"/");
  while (at < plain.size()) {
    const bool is_string = plain[at] == '"';
    const std::size_t end = is_string ? EndOfString(plain, at) : EndOfComment(plain, at);
    for (std::size_t i = at; !is_string && i < end; ++i) {
      if (plain[i] != '\n') plain[i] = ' ';
    }
    at = plain.find_first_of("\"/", std::max(end, at + 1));
  }
  return plain;
}

/// The keys of `object` that are not in `known`.
std::vector<std::string> OtherKeys(const Json& object, const std::vector<std::string>& known) {
  std::vector<std::string> others;
  if (!object.is_object()) return others;
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(known, key) == known.end()) others.push_back(key);
  }
  return others;
}

class ComponentManagerReader {
 public:
  ComponentManagerReader(std::string name, std::string process) : process_(std::move(process)) {
    imported_.file.name = std::move(name);
    ProcessNamed(process_);
  }

  ImportedSystem Read(const Json& json) {
    const Json* inner = json.is_object() ? Find(json, "component-manager") : nullptr;
    if (inner == nullptr) {
      ReadManager(FileObject(json, "", {"components", "connections"}));
    } else {
      for (const std::string& key : OtherKeys(json, {"component-manager"})) {
        LeaveOut(Printable(key, 64), "the key is not inside \"component-manager\"");
      }
      ReadManager(FileObject(*inner, "component-manager", {"components", "connections"}));
    }
    return std::move(imported_);
  }

 private:
  static const Json* Find(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
  }

  SystemFile::Process& ProcessNamed(const std::string& name) {
    auto& processes = imported_.file.processes;
    const auto [place, is_new] = places_.emplace(name, processes.size());
    if (is_new) processes.push_back({name, {}});
    return processes[place->second];
  }

  void ReadManager(const FileObject& manager) {
    manager.ForEach("components", [&](const Json& element, const std::string& place) {
      auto component = ReadComponent(element, place);
      names_.Add(component.name, place + ".constructor-arg.Name");
      known_.insert({process_, component.name});
      ProcessNamed(process_).components.push_back(std::move(component));
    });
    manager.ForEach("connections", [&](const Json& element, const std::string& place) {
      ReadConnection(element, place);
    });
  }

  SystemFile::Component ReadComponent(const Json& json, const std::string& place) {
    const FileObject object(
        json, place, {"shared-library", "class-name", "constructor-arg", "configure-parameter"});
    const FileObject argument = ReadArgument(object.Get("constructor-arg"), object);
    SystemFile::Component component;
    component.name = argument.Name("Name", "component");
    component.class_name = file::ReadClassName(object, "class-name");
    if (object.Find("shared-library") != nullptr) {
      component.library = object.Text("shared-library");
      file::CheckLibrary(component.library, object.Place("shared-library"));
    } else {
      imported_.left_out.push_back(
          place + " has no \"shared-library\": write the name of the plug-in that has class " +
          component.class_name + " into \"library\"");
    }
    const bool is_periodic = argument.Number("Period", "seconds", 0.0) != 0.0;
    if (is_periodic) component.period = argument.Period("Period");
    for (const char* key : {"IsHardRealTime", "NewThread", "StateTableSize"}) {
      if (argument.Find(key) == nullptr) continue;
      LeaveOut(
          argument.Place(key),
          "the class of the component sets this; to change it, use \"thread\" in the system file");
    }
    if (object.Find("configure-parameter") != nullptr) ReadParameter(object, component);
    return component;
  }

  /// Reads the constructor argument of a component. Leaves out keys that only the class knows.
  FileObject ReadArgument(const Json& json, const FileObject& object) {
    std::vector<std::string> keys = {"Name", "Period", "IsHardRealTime", "NewThread",
                                     "StateTableSize"};
    const std::string place = object.Place("constructor-arg");
    for (const std::string& key : OtherKeys(json, keys)) {
      const std::string near = DidYouMean(key, keys);
      LeaveOut(place + "." + Printable(key, 64),
               "only the class of the component can read this key; write the value into "
               "\"configuration\"" +
                   near);
    }
    std::ranges::move(OtherKeys(json, keys), std::back_inserter(keys));
    return {json, place, keys};
  }

  /// Reads "configure-parameter". A JSON object becomes the configuration. Any other text is the
  /// name of a file for the class, and is kept as a comment.
  void ReadParameter(const FileObject& object, SystemFile::Component& component) {
    const std::string text = object.Text("configure-parameter");
    if (text.empty()) return;
    if (const auto parsed = ParseStrictJson(text); parsed && parsed->is_object()) {
      component.configuration =
          file::ConfigurationText(*parsed, object.Place("configure-parameter"));
      return;
    }
    component.comment = "configure-parameter: " + Printable(text, 200);
    LeaveOut(object.Place("configure-parameter"), "kept as a comment; write the content of " +
                                                      Quoted(text, 64) + " into \"configuration\"");
  }

  void LeaveOut(const std::string& place, const std::string& why) {
    imported_.left_out.push_back(place + " is left out: " + why);
  }

  InterfaceName ReadEnd(const FileObject& connection, const std::string& key) {
    const FileObject end(connection.Get(key), connection.Place(key),
                         {"process", "component", "interface"});
    const bool is_here = end.Find("process") == nullptr;
    const InterfaceName name(is_here ? process_ : end.Name("process", "process"),
                             end.Name("component", "component"),
                             end.Name("interface", "interface"));
    if (known_.insert({name.process, name.component}).second) {
      ProcessNamed(name.process).components.push_back({name.component, "", "", ""});
    }
    return name;
  }

  void ReadConnection(const Json& json, const std::string& place) {
    const FileObject object(json, place, {"required", "provided"});
    const InterfaceName required = ReadEnd(object, "required");
    const InterfaceName provided = ReadEnd(object, "provided");
    const auto [other, is_new] = connected_.emplace(required, provided);
    if (!is_new) {
      Refuse(object.Place("required"),
             ToString(required) + " is connected to " + ToString(other->second) + " already");
    }
    imported_.file.connections.push_back({required, provided});
  }

  const std::string process_;
  ImportedSystem imported_;
  std::map<std::string, std::size_t> places_;  // index of each process, by name
  file::UniqueNames names_{"component"};
  std::set<ComponentPath> known_;
  std::map<InterfaceName, InterfaceName> connected_;
};

}  // namespace

Result<ImportedSystem> ParseComponentManagerFile(std::string_view text, const std::string& source,
                                                 const std::string& process) {
  if (auto checked = CheckName("process", process); !checked) return checked.error();
  if (text.size() > SystemFile::kMaxSize) {
    return Error{ErrorCode::kInvalid, source + ": the file is larger than 16 MB"};
  }
  return file::ReadText<ImportedSystem>(WithoutComments(text), source, [&](const Json& json) {
    return ComponentManagerReader(source, process).Read(json);
  });
}

}  // namespace tendon
