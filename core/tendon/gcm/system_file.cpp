#include <tendon/base/os/file.h>
#include <tendon/base/text.h>
#include <tendon/gcm/system_file.h>
#include <tendon/payload/json.h>
#include <tendon/payload/json/strict_json.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

namespace tendon {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

Error Refused(const fs::path& path, const std::string& reason) {
  return {ErrorCode::kInvalid, path.string() + ": " + reason};
}

/// Reads at most kMaxSize bytes of the file, plus one byte, which shows if the file is larger.
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

/// The state that a file requests for a component which is now in `state`: a faulted one should be
/// active, a ready one constructed.
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

/// Must be called first, because later code is recursive and the JSON may be nested too deeply.
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
    return Error{ErrorCode::kInvalid, "system '" + Printable(system.name, 256) +
                                          "' cannot be written as a file: " + why};
  };
  if (const auto checked = CheckConfigurations(system); !checked) {
    return refuse(checked.error().message);
  }
  std::string text;
  try {
    constexpr int kIndent = 2;
    text = JsonOf(system).dump(kIndent) + "\n";
  } catch (const OrderedJson::exception& exception) {  // a text is not UTF-8
    return refuse(exception.what());
  }
  const auto again = ParseSystemFile(text, "it could not be read again");
  return again ? Result<std::string>(std::move(text)) : refuse(again.error().message);
}

Result<void> WriteSystemFile(const fs::path& path, const SystemFile& system) {
  const auto text = SystemFileText(system);
  if (!text) return text.error();
  return os::ReplaceDurably(path, *text);
}

}  // namespace tendon
