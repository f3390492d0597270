#include <gtest/gtest.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/middleware/handshake.h>
#include <tendon/process/version_messages.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/proxy/connection_messages.h>

#include <string>

namespace tendon {
namespace {

template <Payload... Messages>
Fingerprint FingerprintOfAll() {
  std::string texts;
  ((texts += SchemaOf<Messages>().Text()), ...);
  return FingerprintOf(texts);
}

Fingerprint MessagesOfVersion10() {
  return FingerprintOfAll<
      Error, message::Greeting, message::Challenge, message::Proof,  // middleware
      message::OpenInterface, message::OpenInterfaceReply, message::Credit, message::EventsLost,
      message::Pong, message::Mirror, message::MirrorReply,  // proxy
      message::GetSchemas, message::Schemas, message::CallMember, message::CallMemberReply,
      message::Subscribe, message::SubscribeReply, message::RowsHeader,
      message::ProgramVersion,  // process
      message::Join, message::JoinReply, message::Report, message::ConnectionPlan,
      message::PeerList, ConnectionDescription, message::Health, message::GcmClock,
      // membership
      message::CatalogueSnapshot, message::Changes, message::Wire, message::HistoryEntry,
      message::History, message::Forget, message::LogRecords, message::SetLogLevel,
      message::WatchLog, message::WatchLogReply, message::LifecycleOrder, message::LifecycleOutcome,
      message::BeginOrder, message::GetClasses, message::Classes, message::StepSelection,
      message::SystemHealth, message::ProcessOrder, message::Children>();  // gcm
}

TEST(Protocol, ChangedMessagesRequireANewVersion) {
  // Another fingerprint belongs to another version: two programs that know different messages would
  // otherwise misread each other. Raise FrameHeader::kProtocolVersion, then put both down here.
  EXPECT_EQ(FrameHeader::kProtocolVersion, 10);
  EXPECT_EQ(ToString(MessagesOfVersion10()), "bbf7bfcc2fd8e772a5170c660c68b6b2");
  // Add a message that is new since then here, with a fingerprint of its own: a program that does
  // not know it refuses it by its number.
  EXPECT_EQ(ToString(FingerprintOfAll<message::ReadRows, message::ReadRowsReply>()),
            "5910a05dc5cf3af6bca7efc89db06a95");
}

}  // namespace
}  // namespace tendon
