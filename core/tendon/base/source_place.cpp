#include <tendon/base/source_place.h>

namespace tendon {

std::string ToString(const SourcePlace& place) {
  const std::string_view path = place.file_name();
  return std::string(path.substr(path.rfind('/') + 1)) + ":" + std::to_string(place.line());
}

}  // namespace tendon
