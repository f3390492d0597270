#include <tendon/middleware/payload_limit.h>

#include <map>

#include "support/machine/sanitized.h"
#include "system/faults/harness/fault_test.h"

namespace faults {
namespace {

using tendon::ConnectionState;
using tendon::kMaxPayload;
using testing::HasSubstr;

class Payloads : public FaultTest {
 protected:
  using Lcm = std::unique_ptr<Program>;

  [[nodiscard]] bool EventuallyIn(const tendon::InterfaceName& required,
                                  ConnectionState state) const {
    return Eventually([&] {
      const auto catalogue = viewer_->catalogue();
      const auto* connection = catalogue.FindConnection(required);
      return connection != nullptr && connection->state == state;
    });
  }
};

INSTANTIATE_TEST_SUITE_P(Over, Payloads, testing::ValuesIn(Middlewares()), NameOfMiddleware);

/// A program with an edited copy of a type is told the difference. Other programs are not
/// disturbed.
TEST_P(Payloads, ConnectNamesTheFirstDifferenceOfAnEditedType) {
  const std::map<std::string, std::string> differences{
      {"InFloats", "fx of faults.Force: float32 needed, float64 offered"},
      {"InPounds", "fx of faults.Force: float64 in lbf needed, float64 in N offered"},
      {"Renamed", "faults.Force: field x needed, field fx offered"},
      {"WithMore", "faults.Force: field more needed, no further field offered"},
      {"WithLess", "faults.Force: no further field needed, field frame offered"},
      {"InOtherOrder", "faults.Force: field fy needed, field fx offered"},
      {"OfOtherShape", "torque of faults.Force: float64[2] needed, float64[3] offered"},
      {"InOtherFrames", "faults.Frame: camera = 2 needed, no further value offered"}};
  ASSERT_EQ(differences.size(), Edits().size());
  ASSERT_NO_FATAL_FAILURE(StartGcm());
  ASSERT_NO_FATAL_FAILURE(StartViewer());
  const Lcm wrist = MakeLcm("wrist");
  const Lcm hand = MakeLcm("hand");
  ASSERT_TRUE(EventuallyActive("wrist", "sensor")) << wrist->err();
  for (const std::string& edit : Edits()) {
    ASSERT_TRUE(EventuallyActive("hand", edit)) << hand->err();
  }
  const std::string provided = "wrist/sensor/Force";

  for (const auto& [edit, difference] : differences) {
    SCOPED_TRACE(edit);
    const std::string required = "hand/" + edit + "/Force";
    const Outcome refused = Gcm({"connect", required, provided});
    EXPECT_NE(refused.exit_code, 0);
    EXPECT_THAT(refused.err, HasSubstr(required + " does not fit " + provided));
    EXPECT_THAT(refused.err, HasSubstr(difference));
  }

  EXPECT_TRUE(viewer_->catalogue().connections().empty());
  const Outcome fits = Gcm({"connect", "hand/pusher/Force", provided});
  EXPECT_EQ(fits.exit_code, 0) << fits.err;
  EXPECT_TRUE(EventuallyIn({"hand", "pusher", "Force"}, ConnectionState::kActive));
  Tell(std::to_string(differences.size()) + " edited types were refused, the same one connected");
}

/// A sequence of bytes is four bytes longer on the wire. With a sanitizer, the largest payloads
/// would need too much memory, and the others would take longer than a lease.
TEST_P(Payloads, SendsPayloadsUpToTheSizeLimitAndRefusesLargerOnes) {
  std::vector<std::size_t> taken{kMaxPayload / 10 * 9, kMaxPayload};
  std::vector<std::size_t> refused{kMaxPayload + kMaxPayload / 10'000, 10 * kMaxPayload};
  if (tendon::test::IsSanitized()) {
    taken = {kMaxPayload / 64};
    refused.pop_back();
  }
  ASSERT_NO_FATAL_FAILURE(StartGcm());
  ASSERT_NO_FATAL_FAILURE(StartViewer());
  const Lcm post = MakeLcm("post");
  const Lcm shop = MakeLcm("shop");
  const tendon::InterfaceName parcels("shop", "sender", "Parcels");
  ASSERT_TRUE(EventuallyIn(parcels, ConnectionState::kActive)) << shop->err() << post->err();
  ASSERT_TRUE(EventuallyActive("post", "receiver")) << post->err();
  ASSERT_TRUE(EventuallyActive("shop", "sender")) << shop->err();
  const std::size_t changes = watch_->connection_changes();
  const auto send = [&](std::size_t encoded) {
    return Gcm({"call", "shop/sender/Control.Send", std::to_string(encoded - 4)}).out;
  };
  const auto arrives = [&](std::size_t encoded) {
    return Eventually([&] { return Lines("taken", "whole " + std::to_string(encoded - 4)) == 1; });
  };

  for (const std::size_t size : taken) {
    SCOPED_TRACE(size);
    EXPECT_THAT(send(size), HasSubstr("queued"));
    EXPECT_TRUE(arrives(size));
  }
  std::size_t small = 100;
  for (const std::size_t size : refused) {
    SCOPED_TRACE(size);
    EXPECT_THAT(send(size), HasSubstr("invalid"));
    EXPECT_THAT(send(++small), HasSubstr("queued"));
    EXPECT_TRUE(arrives(small)) << "the connection survives";
  }

  EXPECT_TRUE(Eventually([&] {
    return shop->err().find("exceeds max_payload 67 108 864 B of post/receiver/Parcels") !=
           std::string::npos;
  })) << shop->err();
  if (!MayExpireLeases()) {
    EXPECT_EQ(watch_->connection_changes(), changes) << "and has not been made anew";
  }
  EXPECT_EQ(Lines("taken", "damaged"), 0U);
  EXPECT_EQ(Lines("taken"), taken.size() + refused.size());
  for (const char* name : {"post", "shop"}) ExpectNeverLost(name);
}

}  // namespace
}  // namespace faults
