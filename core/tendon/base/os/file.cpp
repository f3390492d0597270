#include <fcntl.h>
#include <tendon/base/os/descriptor.h>
#include <tendon/base/os/file.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace tendon::os {
namespace {

Error Failure(const std::filesystem::path& file) {
  const std::error_code reason(errno, std::generic_category());
  return {ErrorCode::kFailed, "cannot write " + file.string() + ": " + reason.message()};
}

/// Writes all of it and waits for the disk; errno says why not.
bool WriteAll(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return fsync(descriptor) == 0;
}

Result<void> Write(const std::filesystem::path& file, std::string_view text, int flags) {
  constexpr mode_t kMode = 0644;
  const Descriptor descriptor(open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | flags, kMode));
  if (descriptor.get() < 0 || !WriteAll(descriptor.get(), text)) return Failure(file);
  return {};
}

}  // namespace

Result<void> AppendDurably(const std::filesystem::path& file, std::string_view text) {
  return Write(file, text, O_APPEND);
}

Result<void> ReplaceDurably(const std::filesystem::path& file, std::string_view text) {
  std::filesystem::path next = file;
  next += ".new";
  if (auto written = Write(next, text, O_TRUNC); !written) return written;
  std::error_code reason;
  std::filesystem::rename(next, file, reason);
  if (!reason) return {};
  return Error{ErrorCode::kFailed, "cannot write " + file.string() + ": " + reason.message()};
}

}  // namespace tendon::os
