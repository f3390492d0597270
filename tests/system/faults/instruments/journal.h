#pragma once

#include <fcntl.h>
#include <tendon/base/os/file.h>
#include <tendon/payload/payload.h>
#include <unistd.h>

#include <cstdint>
#include <string>

namespace faults {

/// A file of lines that the checkers read. When Add() returns, the line is in the file, even if the
/// writer is killed directly afterwards.
class Journal {
 public:
  /// Opens the file `folder`/`kind`-`source`. Each life of a component has its own file.
  Journal(const std::string& folder, const std::string& kind, std::uint64_t source)
      : file_(open((folder + "/" + kind + "-" + std::to_string(source)).c_str(),
                   O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600)) {}

  /// Returns false if the line could not be written.
  bool Add(const std::string& words) {
    const std::string line = words + "\n";
    return write(file_.get(), line.data(), line.size()) == static_cast<ssize_t>(line.size());
  }

 private:
  tendon::os::Descriptor file_;
};

/// Configuration of components that keep a journal.
struct JournalPlace {
  std::string folder;
};

}  // namespace faults

template <>
inline constexpr auto tendon::kPayload<faults::JournalPlace> =
    tendon::Describe("faults.JournalPlace", tendon::Field{"folder", &faults::JournalPlace::folder});
