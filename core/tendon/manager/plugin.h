#pragma once

#include <tendon/base/os/file_content.h>
#include <tendon/manager/component_registry.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

namespace tendon {

/// Describes a result of TendonPluginAbi(): "tendon 0.1, C++ ABI 1002".
[[nodiscard]] std::string DescribePluginAbi(std::uint64_t abi);

/// A loaded plug-in: its content and its classes.
struct Plugin {
  ComponentRegistry registry;
  os::FileContent content;  ///< content of the file when it was loaded
};

/// Loads the present content of the file, after a probe, and lets it register its classes. Loads a
/// copy, so that the file may be rewritten while the process runs. If this process has already
/// loaded the same content of the same file, it is not loaded again. Errors: one sentence with the
/// path, what was expected and what was found. Thread-safe.
Result<Plugin> LoadPlugin(const std::filesystem::path& file,
                          std::chrono::milliseconds patience = std::chrono::seconds(30));

// The steps of LoadPlugin(). `file` is the copy; errors name `original`.

/// Loads a plug-in and lets it register its classes.
Result<ComponentRegistry> OpenPlugin(const std::filesystem::path& file,
                                     const std::filesystem::path& original);

/// Calls OpenPlugin() in another process, as a test, so that a plug-in that crashes, exits or never
/// returns does no harm. The program is tendon-probe, beside this one or in ../bin of the library;
/// if it is not installed, only the file is checked.
Result<void> ProbePlugin(const std::filesystem::path& file, const std::filesystem::path& original,
                         std::chrono::milliseconds patience);

}  // namespace tendon
