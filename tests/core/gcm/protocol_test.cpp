#include <gtest/gtest.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/middleware/handshake.h>
#include <tendon/process/version_messages.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/proxy/connection_messages.h>
#include <tendon/proxy/mirror_messages.h>

#include <string>

namespace tendon {
namespace {

template <Payload... Messages>
Fingerprint FingerprintOfAll() {
  std::string texts;
  ((texts += SchemaOf<Messages>().Text()), ...);
  return FingerprintOf(texts);
}

Fingerprint MessagesOfVersion9() {
  return FingerprintOfAll<
      Error, message::Greeting, message::Challenge, message::Proof,  // middleware
      message::OpenInterface, message::OpenInterfaceReply, message::OpenMarked,
      message::MarkedOpened, message::Credit, message::EventsLost,
      message::Pong,  // proxy
      message::GetSchemas, message::Schemas, message::CallMember, message::Called,
      message::Subscribe, message::Subscribed, message::RowsHeader,  // process
      message::Join, message::Joined, message::Report, message::Wiring, message::Peers,
      ConnectionDescription, message::Health, message::GcmClock,
      // membership
      message::Snapshot, message::Changes, message::Wire, message::HistoryEntry, message::History,
      message::Forget, message::LogRecords, message::SetLogLevel, message::WatchLog,
      message::WatchLogReply, message::LifeOrder, message::LifeOutcome, message::BeginOrder,
      message::GetClasses, message::Classes, message::StepSelection,
      message::SystemHealth>();  // gcm
}

TEST(Protocol, WhoChangesAMessageRaisesTheVersion) {
  // Another fingerprint belongs to another version: two programs that know different messages would
  // otherwise misread each other. Raise FrameHeader::kProtocolVersion, then put both down here, and
  // keep the messages of the version before as long as that is spoken.
  EXPECT_EQ(FrameHeader::kProtocolVersion, 9);
  EXPECT_EQ(FrameHeader::kOldestVersion, 9);
  EXPECT_EQ(ToString(MessagesOfVersion9()), "5cf5af6d9d9e16d2272843121d99625f");
  // Came since: a program that does not know them refuses them by their numbers.
  EXPECT_EQ(ToString(FingerprintOfAll<message::ProcessOrder>()),
            "d5aa5869dbf7b2967e2cac9f17106c81");
  EXPECT_EQ(ToString(FingerprintOfAll<message::Mirror, message::Mirrored>()),
            "e25f1064d003da76e96f89e74cfdaa8a");
  EXPECT_EQ(ToString(FingerprintOfAll<message::ProgramVersion, message::Children>()),
            "b6e9e4ba5289b94f876d1d3c8c3675f9");
}

}  // namespace
}  // namespace tendon
