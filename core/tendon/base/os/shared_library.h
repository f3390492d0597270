#pragma once

#include <tendon/base/result.h>

#include <filesystem>
#include <string>

namespace tendon::os {

/// Checks that a file looks like a shared library for this machine, without executing any of it.
/// The error text continues after "PATH: ": "expected a shared library for x86-64, found ...".
Result<void> CheckSharedLibrary(const std::filesystem::path& file);

/// Loads a shared library and keeps it for the life of the process. `file` is a copy of `original`:
/// the libraries that it needs from $ORIGIN are taken from the folder of `original`. The error text
/// continues after "PATH: ".
Result<void*> LoadSharedLibrary(const std::filesystem::path& file,
                                const std::filesystem::path& original);

/// The address of a function that the library itself exports, not one that it needs; or null.
void* FindSymbol(void* library, const char* name) noexcept;

/// The shared library or program that has this function, or an empty path.
[[nodiscard]] std::filesystem::path FileOf(const void* function);

}  // namespace tendon::os
