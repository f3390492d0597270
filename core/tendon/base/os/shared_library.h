#pragma once

#include <tendon/base/result.h>

#include <string>

namespace tendon::os {

/// Loads a shared library and keeps it for the life of the process. The error is the loader's own
/// sentence.
Result<void*> LoadSharedLibrary(const std::string& file);

/// The address of an exported function, or null.
void* FindSymbol(void* library, const char* name) noexcept;

}  // namespace tendon::os
