#pragma once

#include <tendon/manager/component_registry.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

namespace tendon {

/// "tendon 0.1, C++ ABI 1017" for what TendonPluginAbi() returns.
[[nodiscard]] std::string DescribePluginAbi(std::uint64_t abi);

/// Loads a plug-in and lets it register its classes. Errors: one sentence with the path, what was
/// expected and what was found.
Result<ComponentRegistry> OpenPlugin(const std::filesystem::path& file);

/// Whether OpenPlugin() would succeed, tried in another process (the program tendon-probe, beside
/// this one or in ../bin of the library), so that a plug-in which crashes, ends the process or
/// never finishes harms nobody. Where that program is not installed, only the file is looked at.
Result<void> ProbePlugin(const std::filesystem::path& file,
                         std::chrono::milliseconds patience = std::chrono::seconds(30));

}  // namespace tendon
