#pragma once

#include <tendon/base/os/loading/file_content.h>
#include <tendon/manager/component_registry.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

namespace tendon {

/// "tendon 0.1, C++ ABI 1017" for what TendonPluginAbi() returns.
[[nodiscard]] std::string DescribePluginAbi(std::uint64_t abi);

/// A plug-in that is loaded.
struct Plugin {
  ComponentRegistry registry;
  os::FileContent content;  ///< of its file, when it was loaded
};

/// Loads what is in the file now, once it has been probed, and lets it register its classes: a
/// copy, so that the file may be written again while it runs. What this process has loaded already
/// of the same file is not loaded twice. Errors: one sentence with the path, what was expected and
/// what was found. Thread-safe.
Result<Plugin> LoadPlugin(const std::filesystem::path& file,
                          std::chrono::milliseconds patience = std::chrono::seconds(30));

// What LoadPlugin() does with the copy, which is `file`; `original` is what errors name.

/// Loads a plug-in and lets it register its classes.
Result<ComponentRegistry> OpenPlugin(const std::filesystem::path& file,
                                     const std::filesystem::path& original);

/// Whether OpenPlugin() would succeed, tried in another process (the program tendon-probe, beside
/// this one or in ../bin of the library), so that a plug-in which crashes, ends the process or
/// never finishes harms nobody. Where that program is not installed, only the file is looked at.
Result<void> ProbePlugin(const std::filesystem::path& file, const std::filesystem::path& original,
                         std::chrono::milliseconds patience);

}  // namespace tendon
