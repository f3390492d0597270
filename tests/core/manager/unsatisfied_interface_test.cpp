#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/manager/unsatisfied_interface.h>

#include <string>
#include <vector>

namespace tendon {
namespace {

using testing::IsEmpty;

const std::vector<ConnectionDescription> kNone;

MemberDescription Member(const std::string& name, bool optional = false) {
  return {.name = name, .optional = optional};
}

RequiredDescription Robot() { return {.name = "Robot", .functions = {Member("Stop")}}; }

ComponentDescription Client(const std::vector<RequiredDescription>& required) {
  ComponentDescription client{.name = "client"};
  for (const auto& one : required) client.required.push_back(one);
  return client;
}

ConnectionDescription Connected(const std::string& interface,
                                ConnectionState state = ConnectionState::kActive,
                                const std::string& reason = "") {
  return {.id = 1,
          .required = {"desk", "client", interface},
          .provided = {"robot", "arm", "Control"},
          .state = state,
          .reason = reason};
}

TEST(UnsatisfiedInterface, IsARequiredInterfaceWithoutAConnection) {
  const auto needs = UnmetNeedsOf(Client({Robot()}), kNone);

  ASSERT_EQ(needs.size(), 1U);
  EXPECT_EQ(needs[0].interface, "Robot");
  EXPECT_EQ(needs[0].reason, "not connected");
  EXPECT_FALSE(needs[0].has_connection);
}

TEST(UnsatisfiedInterface, ExcludesConnectedInterfaces) {
  EXPECT_THAT(UnmetNeedsOf(Client({Robot()}), {Connected("Robot")}), IsEmpty());
}

TEST(UnsatisfiedInterface, IgnoresConnectionsOfOtherComponents) {
  ConnectionDescription other = Connected("Robot");
  other.required.component = "another";

  EXPECT_EQ(UnmetNeedsOf(Client({Robot()}), {other}).size(), 1U);
}

TEST(UnsatisfiedInterface, NamesTheReasonOfAnInactiveConnection) {
  const auto reason = [](ConnectionState state, const std::string& why) {
    const auto needs = UnmetNeedsOf(Client({Robot()}), {Connected("Robot", state, why)});
    EXPECT_EQ(needs.size(), 1U);
    EXPECT_TRUE(needs.at(0).has_connection);
    return needs.at(0).reason;
  };

  EXPECT_EQ(reason(ConnectionState::kPending, "process 'robot' is not available"),
            "pending: process 'robot' is not available");
  EXPECT_EQ(reason(ConnectionState::kPending, ""), "pending");
  EXPECT_EQ(reason(ConnectionState::kFailed, "it does not fit"), "failed: it does not fit");
}

TEST(UnsatisfiedInterface, ExcludesOptionalInterfaces) {
  RequiredDescription optional = Robot();
  optional.optional = true;
  const RequiredDescription of_optional_members{.name = "Viewer",
                                                .functions = {Member("Show", true)},
                                                .event_handlers = {Member("Closed", true)}};
  const RequiredDescription empty{.name = "Nothing"};

  EXPECT_THAT(UnmetNeedsOf(Client({optional, of_optional_members, empty}), kNone), IsEmpty());
}

TEST(UnsatisfiedInterface, IncludesInterfacesWithOnlyEvents) {
  const RequiredDescription events{.name = "Alarm", .event_handlers = {Member("Raised")}};
  const RequiredDescription partly{.name = "Viewer",
                                   .functions = {Member("Show", true), Member("Hide")}};

  EXPECT_EQ(NamesOf(UnmetNeedsOf(Client({events, partly}), kNone)), "Alarm, Viewer");
}

TEST(UnsatisfiedInterface, RefusesAStartByNameAndReason) {
  RequiredDescription camera = Robot();
  camera.name = "Camera";
  const auto needs = UnmetNeedsOf(Client({Robot(), camera}),
                                  {Connected("Camera", ConnectionState::kPending, "gone")});

  EXPECT_EQ(CheckNeeds("client", needs).error().message,
            "component 'client' is not started, because it would wait for Robot: not connected; "
            "Camera: pending: gone; make these connections first");
  EXPECT_TRUE(CheckNeeds("client", {}));
}

}  // namespace
}  // namespace tendon
