#include <gmock/gmock.h>
#include <tendon/gcm/client.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/ice/ice_middleware.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/membership_messages.h>
#include <tendon/process/process.h>

#include <string>

#include "core/security/authority.h"
#include "support/plant.h"
#include "support/program.h"
#include "support/wait.h"

namespace tendon {
namespace {

using plant::Operator;
using plant::Plant;
using testing::HasSubstr;

constexpr std::chrono::seconds kTestTimeout(120);

/// A GCM and processes under TLS. Each program has its own certificate.
class CertifiedSystem : public AuthorityTest {
 protected:
  Result<std::unique_ptr<GlobalManager>> MakeGcm(std::shared_ptr<Middleware> middleware) const {
    return GlobalManager::Start(
        std::move(middleware),
        {.address = address_, .state_folder = home.path() / "state", .clock = &SteadyClock()});
  }
  void StartGcm() {
    auto gcm = MakeGcm(As("gcm", Role::kOperator, Holder::kProcess));
    ASSERT_TRUE(gcm.ok()) << gcm.error().message;
    gcm_ = *std::move(gcm);
  }
  [[nodiscard]] std::unique_ptr<Process> Start(
      const std::string& name, const std::shared_ptr<Middleware>& middleware) const {
    return std::make_unique<Process>(name,
                                     ProcessOptions{.middleware = middleware, .gcm = address_});
  }
  [[nodiscard]] std::unique_ptr<Process> StartJoined(const std::string& name) const {
    auto process = Start(name, As(name, Role::kOperator, Holder::kProcess));
    const auto joined = process->WaitUntilJoined(kTestTimeout);
    EXPECT_TRUE(joined.ok()) << joined.error().message;
    return process;
  }
  [[nodiscard]] std::unique_ptr<GcmClient> Client(const std::string& name, Role role) const {
    auto client = std::make_unique<GcmClient>(
        As(name, role, Holder::kPerson),
        GcmClient::Options{.name = "gcm", .address = address_, .timeout = kTestTimeout});
    EXPECT_TRUE(client->WaitUntilWatching().ok());
    return client;
  }
  [[nodiscard]] std::shared_ptr<Middleware> As(const std::string& name, Role role,
                                               Holder holder) const {
    const auto issued = Issue({.name = name, .role = role, .holder = holder});
    auto made =
        MakeIceMiddleware(Credentials{.certificate = issued.certificate_file, .authority = folder});
    EXPECT_TRUE(made.ok());
    return *std::move(made);
  }
  /// A program that only has a channel, and may have joined.
  struct Member {
    std::shared_ptr<Channel> channel;
    Result<message::JoinReply> joined;
  };
  /// Joins with a publicly known instance id. `token` is the token of a membership, or 0.
  [[nodiscard]] Member JoinByHand(const std::shared_ptr<Middleware>& middleware,
                                  const std::string& name, std::uint64_t token) const {
    constexpr std::uint64_t kInstance = 7;
    const auto channel = Channel::Open(*middleware, address_,
                                       {.instance = kInstance, .name = name, .session = token},
                                       std::make_shared<ChannelHandler>(), kTestTimeout);
    if (!channel) return {nullptr, channel.error()};
    const message::Join join{.process = {.name = name, .instance = kInstance}};
    return {*channel, (*channel)->Call<message::JoinReply>(message::kJoin, 0, join, kTestTimeout)};
  }
  static Result<std::string> Stop(GcmClient& client) {
    return Wait<std::string>(2 * kTestTimeout, [&](auto done) {
      client.Call("robot/plant/Control.Stop", "", std::move(done));
    });
  }
  static bool Sees(const GcmClient& client, const std::string& process) {
    return EventuallyTrue([&] {
      const auto catalogue = client.catalogue();
      const auto* entry = catalogue.FindProcess(process);
      return entry != nullptr && !entry->components.empty();
    });
  }

  const std::string address_ = "127.0.0.1:" + std::to_string(FreePort());
  std::unique_ptr<GlobalManager> gcm_;
};

TEST_F(CertifiedSystem, ComponentsOfTwoProcessesCommunicate) {
  ASSERT_NO_FATAL_FAILURE(StartGcm());
  const auto robot = StartJoined("robot");
  auto& plant = robot->Add<Plant>("plant");
  const auto desk = StartJoined("desk");
  auto& user = desk->Add<Operator>("operator");
  ASSERT_TRUE(desk->Connect({"desk", "operator", "Robot"}, {"robot", "plant", "Control"}).ok());
  ASSERT_TRUE(robot->StartAll().ok());
  ASSERT_TRUE(desk->StartAll().ok());

  EXPECT_TRUE(EventuallyTrue([&] { return static_cast<bool>(user.stop()); }));
  EXPECT_TRUE(EventuallyTrue([&] { return plant.stops.size() > 0; }));
}

TEST_F(CertifiedSystem, TheCertificateDeterminesAPersonsRights) {
  ASSERT_NO_FATAL_FAILURE(StartGcm());
  const auto robot = StartJoined("robot");
  auto& plant = robot->Add<Plant>("plant");
  ASSERT_TRUE(robot->StartAll().ok());
  const auto anna = Client("anna", Role::kOperator);
  const auto vera = Client("vera", Role::kViewer);
  ASSERT_TRUE(Sees(*anna, "robot"));
  ASSERT_TRUE(Sees(*vera, "robot"));

  const auto refused = Stop(*vera);
  const auto forgotten =
      Wait<void>(kTestTimeout, [&](auto done) { vera->Forget("robot", std::move(done)); });
  const auto allowed = Stop(*anna);

  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kDenied);
  EXPECT_THAT(refused.error().message,
              HasSubstr("needs the role operator, but 'vera (gcm)' is a viewer"));
  ASSERT_FALSE(forgotten.ok());
  EXPECT_EQ(forgotten.error().code, ErrorCode::kDenied);
  EXPECT_TRUE(allowed.ok()) << allowed.error().message;
  EXPECT_TRUE(EventuallyTrue([&] { return plant.stops.size() == 1; }));
}

TEST_F(CertifiedSystem, RefusesAJoinUnderAnothersName) {
  ASSERT_NO_FATAL_FAILURE(StartGcm());

  const auto by_process =
      Start("robot", As("arm", Role::kOperator, Holder::kProcess))->WaitUntilJoined(kTestTimeout);
  const auto by_person =
      Start("robot", As("robot", Role::kOperator, Holder::kPerson))->WaitUntilJoined(kTestTimeout);

  for (const auto& joined : {by_process, by_person}) {
    ASSERT_FALSE(joined.ok());
    EXPECT_EQ(joined.error().code, ErrorCode::kDenied);
    EXPECT_THAT(joined.error().message, HasSubstr("cannot join as process 'robot'"));
  }
}

/// The token of a membership allows its holder to continue the membership over another link.
TEST_F(CertifiedSystem, ASessionTokenIsBoundToItsCertificate) {
  ASSERT_NO_FATAL_FAILURE(StartGcm());
  const auto robot = As("robot", Role::kOperator, Holder::kProcess);
  const auto thief = As("arm", Role::kOperator, Holder::kProcess);
  const auto member = JoinByHand(robot, "robot", 0);
  ASSERT_TRUE(member.joined.ok()) << member.joined.error().message;
  const std::uint64_t token = member.joined->session;

  const auto stolen = JoinByHand(thief, "robot", token);
  const auto beside = JoinByHand(thief, "arm", token);

  ASSERT_FALSE(stolen.joined.ok());
  EXPECT_EQ(stolen.joined.error().code, ErrorCode::kDenied);
  EXPECT_THAT(stolen.joined.error().message,
              HasSubstr("'arm (robot)' cannot join as process 'robot'"));
  ASSERT_TRUE(beside.joined.ok()) << "it is what its certificate says";
  EXPECT_NE(beside.joined->session, token);
  EXPECT_TRUE(member.channel->Call<None>(message::kRenew, 0, None{}, kTestTimeout).ok())
      << "and the member is still one";

  const auto again = JoinByHand(robot, "robot", token);
  EXPECT_TRUE(again.joined.ok()) << again.joined.error().message;
  EXPECT_NE(again.joined->session, token);
}

TEST_F(CertifiedSystem, RefusesToJoinAnImpostorGcm) {
  const auto impostor = As("arm", Role::kOperator, Holder::kProcess);
  const auto listener = impostor->Listen(
      address_, Channel::Acceptor({.instance = 1, .name = kGcmName},
                                  [] { return std::make_shared<ChannelHandler>(); }));
  ASSERT_TRUE(listener.ok());

  const auto joined =
      Start("robot", As("robot", Role::kOperator, Holder::kProcess))->WaitUntilJoined(kTestTimeout);

  ASSERT_FALSE(joined.ok());
  EXPECT_EQ(joined.error().code, ErrorCode::kDenied);
  EXPECT_THAT(joined.error().message, HasSubstr("shows the certificate of the process 'arm'"));
}

TEST_F(CertifiedSystem, AGcmWithAForeignCertificateDoesNotStart) {
  for (const auto& middleware :
       {As("arm", Role::kOperator, Holder::kProcess), As("gcm", Role::kViewer, Holder::kProcess)}) {
    const auto gcm = MakeGcm(middleware);

    ASSERT_FALSE(gcm.ok());
    EXPECT_EQ(gcm.error().code, ErrorCode::kDenied);
    EXPECT_THAT(gcm.error().message, HasSubstr("a GCM needs the certificate of a process 'gcm'"));
  }
}

}  // namespace
}  // namespace tendon
