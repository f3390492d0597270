#include <tendon/recording/recording_format.h>

namespace tendon::recording {
namespace {

constexpr std::byte kLittleEndian{1};

}  // namespace

mcap::ByteView BodyOf(mcap::ByteView data) {
  const bool is_read =
      data.size() >= kEncapsulationSize && data[0] == std::byte{0} && data[1] == kLittleEndian;
  return is_read ? data.subspan(kEncapsulationSize) : mcap::ByteView();
}

void Encapsulate(mcap::ByteView body, mcap::Buffer& data) {
  data.assign(kEncapsulationSize, std::byte{0});
  data[1] = kLittleEndian;
  data.insert(data.end(), body.begin(), body.end());
}

std::string MetadataValue(const mcap::Channel& channel, const char* key) {
  const auto found = channel.metadata.find(key);
  return found == channel.metadata.end() ? std::string() : found->second;
}

std::string TopicOf(const InterfaceName& source, const std::string& member) {
  return ToString(source) + "/" + member;
}

const char* RosLogDefinition() {
  return "byte DEBUG=10\n"
         "byte INFO=20\n"
         "byte WARN=30\n"
         "byte ERROR=40\n"
         "byte FATAL=50\n"
         "builtin_interfaces/Time stamp\n"
         "uint8 level\n"
         "string name\n"
         "string msg\n"
         "string file\n"
         "string function\n"
         "uint32 line\n"
         "================================================================================\n"
         "MSG: builtin_interfaces/Time\n"
         "int32 sec\n"
         "uint32 nanosec\n";
}

}  // namespace tendon::recording
