#include <fcntl.h>
#include <sys/stat.h>
#include <tendon/base/os/descriptor.h>
#include <tendon/base/os/private_file.h>
#include <tendon/base/os/process.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <optional>
#include <system_error>

namespace tendon::os {
namespace {

Error Denied(const std::filesystem::path& file, int reason) {
  return {ErrorCode::kDenied,
          file.string() + ": " + std::error_code(reason, std::generic_category()).message()};
}

/// Empty if there is no such file.
std::optional<Result<std::string>> Read(const std::filesystem::path& file) {
  const Descriptor descriptor(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
  if (descriptor.get() < 0) {
    if (errno == ENOENT) return std::nullopt;
    return Denied(file, errno);
  }
  struct stat status {};
  if (fstat(descriptor.get(), &status) != 0) return Denied(file, errno);
  if (status.st_uid != geteuid() || (status.st_mode & 077U) != 0 || !S_ISREG(status.st_mode)) {
    return Error{ErrorCode::kDenied, file.string() +
                                         " must belong to you, and only you may read it (mode "
                                         "0600): remove it, then start again"};
  }
  std::array<char, 256> content{};
  const auto size = read(descriptor.get(), content.data(), content.size());
  if (size < 0) return Denied(file, errno);
  return std::string(content.data(), static_cast<std::size_t>(size));
}

}  // namespace

Result<std::string> ReadOrMakePrivateFile(const std::filesystem::path& file,
                                          const std::string& content) {
  if (auto found = Read(file)) return *std::move(found);

  // Write under another name, then link: no reader ever sees a partial file.
  const std::filesystem::path draft = file.string() + "." + std::to_string(RandomNumber());
  {
    const Descriptor descriptor(open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
    if (descriptor.get() < 0) return Denied(draft, errno);
    const auto written = write(descriptor.get(), content.data(), content.size());
    if (written != static_cast<ssize_t>(content.size())) {
      unlink(draft.c_str());
      return Denied(draft, ENOSPC);
    }
  }
  const int failure = link(draft.c_str(), file.c_str()) == 0 ? 0 : errno;
  unlink(draft.c_str());
  if (failure != 0 && failure != EEXIST) return Denied(file, failure);
  if (auto found = Read(file)) return *std::move(found);
  return Denied(file, ENOENT);
}

}  // namespace tendon::os
