#include <gtest/gtest.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/middleware/handshake.h>
#include <tendon/process/viewer_messages.h>

#include <fstream>
#include <sstream>
#include <string>

namespace tendon {
namespace {

template <Payload... Messages>
std::string TextsOf() {
  std::string texts;
  ((texts += SchemaOf<Messages>().Text() + "\n"), ...);
  return texts;
}

std::string ContentOf(const std::string& file) {
  std::ostringstream content;
  content << std::ifstream(file).rdbuf();
  return content.str();
}

TEST(PythonPackage, SchemasMatchTheMessages) {
  const std::string texts =
      TextsOf<Error, message::Greeting, message::Challenge, message::Proof,  // middleware
              message::GetSchemas, message::Schemas, message::CallMember, message::CallMemberReply,
              message::Subscribe, message::SubscribeReply, message::RowsHeader,  // process
              message::ConnectionEnds, ConnectionDescription,                    // membership
              message::CatalogueSnapshot, message::Changes>();                   // gcm
  std::ofstream(TENDON_PYTHON_MESSAGES_BUILT) << texts;

  EXPECT_TRUE(ContentOf(TENDON_PYTHON_MESSAGES) == texts)
      << "a message has changed: cp " TENDON_PYTHON_MESSAGES_BUILT " " TENDON_PYTHON_MESSAGES
      << ", and see whether the package still says what it should";
}

TEST(PythonPackage, ProtocolVersionMatches) {
  const std::string frame = ContentOf(TENDON_PYTHON_FRAME);
  const std::string line = "PROTOCOL_VERSION = " + std::to_string(FrameHeader::kProtocolVersion);

  EXPECT_NE(frame.find("\n" + line + "\n"), std::string::npos)
      << "another protocol: set " << line << " in " TENDON_PYTHON_FRAME;
}

}  // namespace
}  // namespace tendon
