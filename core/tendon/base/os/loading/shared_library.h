#pragma once

#include <tendon/base/result.h>

#include <filesystem>
#include <string>

namespace tendon::os {

/// Whether a file can be a shared library of this machine, seen from the file alone: nothing of it
/// is executed. The error goes on after "PATH: ": "expected a shared library for x86-64, found
/// ...".
Result<void> CheckSharedLibrary(const std::filesystem::path& file);

/// Loads a shared library and keeps it for the life of the process. `original` is where the file
/// was copied from: a library that it needs from $ORIGIN, the folder of the file, is taken from
/// there. The error goes on after "PATH: ", too.
Result<void*> LoadSharedLibrary(const std::filesystem::path& file,
                                const std::filesystem::path& original);

/// The address of a function which the library itself exports, not one that it needs; or null.
void* FindSymbol(void* library, const char* name) noexcept;

/// The shared library or program which has this function, or an empty path.
[[nodiscard]] std::filesystem::path FileOf(const void* function);

}  // namespace tendon::os
