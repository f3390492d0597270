#include <tendon/base/os/file.h>
#include <tendon/gcm/system_file.h>
#include <tendon/payload/json/strict_json.h>

#include <algorithm>
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

/// The file's bytes, at most one more than kMaxSize.
Result<std::string> ReadBytes(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text(SystemFile::kMaxSize + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad() || (stream.fail() && !stream.eof())) return Refused(path, "cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

OrderedJson ToJson(const SystemFile::Component& component) {
  OrderedJson json;
  json["name"] = component.name;
  json["class"] = component.class_name;
  if (!component.library.empty()) json["library"] = component.library;
  if (!component.configuration.empty()) {
    json["configuration"] = OrderedJson::parse(component.configuration);
  }
  return json;
}

OrderedJson ToJson(const SystemFile& system) {
  OrderedJson json;
  json["version"] = SystemFile::kVersion;
  json["name"] = system.name;
  json["processes"] = OrderedJson::array();
  for (const auto& process : system.processes) {
    OrderedJson components = OrderedJson::array();
    for (const auto& component : process.components) components.push_back(ToJson(component));
    json["processes"].push_back({{"name", process.name}, {"components", std::move(components)}});
  }
  json["connections"] = OrderedJson::array();
  for (const auto& connection : system.connections) {
    json["connections"].push_back(
        {{"required", ToString(connection.required)}, {"provided", ToString(connection.provided)}});
  }
  return json;
}

}  // namespace

const SystemFile::Process* SystemFile::FindProcess(const std::string& process_name) const {
  const auto found = std::find_if(processes.begin(), processes.end(), [&](const Process& process) {
    return process.name == process_name;
  });
  return found == processes.end() ? nullptr : &*found;
}

Result<SystemFile> ReadSystemFile(const fs::path& path) {
  std::error_code reason;
  const fs::file_status status = fs::status(path, reason);
  if (status.type() == fs::file_type::not_found) {
    return Error{ErrorCode::kNotFound, path.string() + ": there is no such file"};
  }
  if (status.type() == fs::file_type::directory) {
    return Refused(path, "is a folder, not a system file");
  }
  if (reason) return Refused(path, reason.message());
  if (status.type() != fs::file_type::regular) return Refused(path, "is no regular file");
  const auto text = ReadBytes(path);
  if (!text) return text.error();
  return ParseSystemFile(*text, path.string());
}

Result<std::string> SystemFileText(const SystemFile& system) {
  try {
    constexpr int kIndent = 2;
    return ToJson(system).dump(kIndent) + "\n";
  } catch (const OrderedJson::exception& exception) {
    return Error{ErrorCode::kInvalid,
                 "system '" + system.name +
                     "' cannot be written, for a text in it is no JSON: " + exception.what()};
  }
}

Result<void> WriteSystemFile(const fs::path& path, const SystemFile& system) {
  const auto text = SystemFileText(system);
  if (!text) return text.error();
  return os::ReplaceDurably(path, *text);
}

}  // namespace tendon
