#include <dlfcn.h>
#include <tendon/base/os/shared_library.h>

namespace tendon::os {

Result<void*> LoadSharedLibrary(const std::string& file) {
  if (void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) return library;
  const char* reason = dlerror();
  return Error{ErrorCode::kFailed, reason != nullptr ? reason : "unknown loader error"};
}

void* FindSymbol(void* library, const char* name) noexcept { return dlsym(library, name); }

}  // namespace tendon::os
