#pragma once

#include <tendon/base/os/file_content.h>
#include <tendon/manager/component_registry.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

namespace tendon {

/// Returns the text for a result of TendonPluginAbi(): "tendon 0.1, C++ ABI 1002".
[[nodiscard]] std::string DescribePluginAbi(std::uint64_t abi);

/// A loaded plug-in.
struct Plugin {
  ComponentRegistry registry;
  os::FileContent content;  ///< content of the file at the time of loading
};

/// Loads a plug-in and lets it register its classes. First tests it with ProbePlugin(). Loads a
/// copy of the file, so that the file can be overwritten while the process runs. Content that this
/// process has already loaded from this file is not loaded again. An error says which file, what
/// was expected and what was found. Thread-safe.
Result<Plugin> LoadPlugin(const std::filesystem::path& file,
                          std::chrono::milliseconds timeout = std::chrono::seconds(30));

// The steps of LoadPlugin(). `file` is the copy. Errors name the file `original`.

/// Loads a plug-in and lets it register its classes.
Result<ComponentRegistry> OpenPlugin(const std::filesystem::path& file,
                                     const std::filesystem::path& original);

/// Tests a plug-in: calls OpenPlugin() in another process, so that a plug-in that crashes, exits or
/// never returns does no harm. The program for this is tendon-probe, which is in the folder of this
/// program, or in ../bin relative to the Tendon library. If it is not installed, only the format of
/// the file is checked.
Result<void> ProbePlugin(const std::filesystem::path& file, const std::filesystem::path& original,
                         std::chrono::milliseconds timeout);

}  // namespace tendon
