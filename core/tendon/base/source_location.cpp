#include <tendon/base/source_location.h>

namespace tendon {

std::string ToString(const SourceLocation& location) {
  const std::string_view path = location.file_name();
  return std::string(path.substr(path.rfind('/') + 1)) + ":" + std::to_string(location.line());
}

}  // namespace tendon
