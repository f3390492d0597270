#pragma once

#include <tendon/base/result.h>

#include <filesystem>
#include <string>

namespace tendon::os {

/// Checks that a file looks like a shared library for this machine, without executing any of it.
/// The error text is "expected a shared library for x86-64, found ..."; the caller puts "PATH: "
/// before it.
Result<void> CheckSharedLibrary(const std::filesystem::path& file);

/// Loads a shared library and keeps it until the process ends. `file` is a copy of `original`; the
/// libraries that it needs from $ORIGIN are taken from the folder of `original`. The error text has
/// no path: the caller puts "PATH: " before it.
Result<void*> LoadSharedLibrary(const std::filesystem::path& file,
                                const std::filesystem::path& original);

/// Returns the address of a function that the library itself exports, or null. Functions of other
/// libraries that the library needs are not found.
void* FindSymbol(void* library, const char* name) noexcept;

/// Returns the file of the shared library or program that contains this function, or an empty path.
[[nodiscard]] std::filesystem::path FileOf(const void* function);

}  // namespace tendon::os
