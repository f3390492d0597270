#include <gmock/gmock.h>
#include <tendon/base/os/process.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/proxy/connection_messages.h>

#include <chrono>
#include <mutex>

#include "core/process/connections/remote_connection.h"

namespace {

using tendon::Channel;
using tendon::ErrorCode;
using tendon::Schema;
using tendon::message::OpenInterface;
using tendon::message::OpenInterfaceReply;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::chrono::seconds kRefusalTimeout(120);

/// A payload that needs mailbox slots of 64 KiB.
struct Picture {
  std::array<double, 8192> pixels{};
};

}  // namespace

template <>
inline constexpr auto tendon::kPayload<Picture> =
    tendon::Describe("test.Picture", tendon::Field{"pixels", &Picture::pixels});

namespace {

/// Shows pictures.
class Screen final : public tendon::Component {
 public:
  explicit Screen(std::string name)
      : Component(std::move(name), std::make_unique<tendon::Inbox>()) {
    AddProvidedInterface("Screen").AddCommandWrite(&Screen::Show, this, "Show");
  }

 private:
  void Show(const Picture& /*picture*/) {}
};

class Camera final : public tendon::Component {
 public:
  Camera(std::string name, std::size_t capacity) : Component(std::move(name)) {
    auto& screen = AddRequiredInterface("Screen");
    screen.AddFunction(show, "Show");
    screen.SetMailboxCapacity(capacity);
  }
  tendon::WriteFunction<Picture> show;
};

using MailboxSizeLimit = RemoteConnection;

TEST_P(MailboxSizeLimit, RefusesTooManyCalls) {
  StartRobot();
  StartDesk(std::size_t{1} << 24U);

  const auto id = desk->Connect(kRobot, kControl);

  ASSERT_FALSE(id.ok());
  EXPECT_EQ(id.error().code, ErrorCode::kInvalid);
  EXPECT_EQ(id.error().message,
            "desk/operator/Robot requests a mailbox for 16777216 calls at robot/plant/Control, but "
            "a client in another process is allowed at most 65536 calls and 64 MiB: set a smaller "
            "mailbox capacity");
  EXPECT_EQ(robot->proxies().size(), 0U);
}

TEST_P(MailboxSizeLimit, RefusesTooManyBytes) {
  robot = Start("robot");
  robot->Add<Screen>("screen");
  desk = Start("desk");
  desk->Add<Camera>("large", 4096U);
  desk->Add<Camera>("small", 64U);

  const auto large = desk->Connect({"large", "Screen"}, {"robot", "screen", "Screen"});
  const auto small = desk->Connect({"small", "Screen"}, {"robot", "screen", "Screen"});

  ASSERT_FALSE(large.ok());
  EXPECT_EQ(large.error().code, ErrorCode::kInvalid);
  EXPECT_THAT(large.error().message,
              StartsWith("desk/large/Screen requests a mailbox for 4096 calls at "
                         "robot/screen/Screen, but a client in another process"));
  EXPECT_TRUE(small.ok()) << small.error().message;
  EXPECT_TRUE(EventuallyActive(*desk, 1));
}

INSTANTIATE_TEST_SUITE_P(Over, MailboxSizeLimit, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

/// A process with its own type. It describes the type on request.
class Foreigner final : public tendon::ChannelHandler {
 public:
  enum class Manner { kHonest, kLying, kSilent };
  Foreigner(const Schema& schema, Manner manner) : text_(schema.Text()), manner_(manner) {
    if (manner == Manner::kLying) text_ = Schema(Schema::Kind::kBool).Text();
  }

 private:
  void OnRequest(const std::shared_ptr<Channel>& channel, const tendon::FrameHeader& header,
                 std::span<const std::byte> body, tendon::Responder responder) override {
    if (header.type != tendon::message::kGetSchemas) {
      return ChannelHandler::OnRequest(channel, header, body, std::move(responder));
    }
    if (manner_ == Manner::kSilent) {
      const std::scoped_lock lock(mutex_);
      kept_.push_back(std::move(responder));
      return;
    }
    responder.Reply(tendon::EncodeBody(tendon::message::Schemas{.texts = {text_}}));
  }

  std::string text_;
  const Manner manner_;
  std::mutex mutex_;
  std::vector<tendon::Responder> kept_;
};

Schema Goal(const std::string& unit, Schema::Kind kind = Schema::Kind::kFloat64) {
  return Schema::Structure("plant.Move", {{"number", "", Schema(Schema::Kind::kUint64)},
                                          {"goal", unit, Schema::Array(Schema(kind), 3)}});
}

class TypeMismatch : public RemoteConnection {
 protected:
  /// Requests a connection from robot that needs MoveTo of this type. Returns the message of robot.
  std::string WhyRefused(const Schema& schema,
                         Foreigner::Manner manner = Foreigner::Manner::kHonest) {
    const auto channel =
        Channel::Open(*middleware, robot->address(),
                      {.instance = tendon::os::RandomNumber(),
                       .name = "desk",
                       .cookie = *tendon::LoopbackCookie()},
                      std::make_shared<Foreigner>(schema, manner), kRefusalTimeout);
    EXPECT_TRUE(channel.ok()) << channel.error().message;
    OpenInterface open{.required = kRobot, .provided = kControl, .handle = 1, .capacity = 64};
    open.description.name = "Robot";
    open.description.functions.push_back(
        {.name = "MoveTo",
         .signature = {tendon::CommandKind::kWrite, schema.fingerprint(),
                       tendon::FingerprintOf<tendon::None>()},
         .in_type = schema.name()});
    const auto opened = (*channel)->Call<OpenInterfaceReply>(tendon::message::kOpenInterface, 0,
                                                             open, kRefusalTimeout);
    (*channel)->Close();
    EXPECT_FALSE(opened.ok());
    if (opened.ok()) return "accepted";
    EXPECT_EQ(opened.error().code, ErrorCode::kIncompatible);
    return opened.error().message;
  }

  /// Expects a message with this difference. Repeats the request, because robot waits only briefly
  /// for the text of the type, which is too short on a machine that stalls.
  void ExpectDifference(const Schema& schema, const std::string& difference) {
    std::string why;
    EXPECT_TRUE(EventuallyTrue([&] {
      why = WhyRefused(schema);
      return why == kFrame + "(" + difference + ")";
    })) << why;
  }

  const std::string kFrame =
      "desk/operator/Robot does not fit robot/plant/Control: needs write command 'MoveTo' of "
      "plant.Move, but the provider offers another plant.Move ";
  std::shared_ptr<tendon::Middleware> middleware = NewMiddleware();
};

TEST_P(TypeMismatch, NamesTheFirstDifferenceOfAnUnknownType) {
  StartRobot();

  ExpectDifference(Goal("deg"),
                   "goal of plant.Move: float64[3] in deg needed, float64[3] in rad offered");
  ExpectDifference(Goal("rad", Schema::Kind::kFloat32),
                   "goal of plant.Move: float32[3] needed, float64[3] offered");
  ExpectDifference(
      Schema::Structure("plant.Move", {{"number", "", Schema(Schema::Kind::kUint64)},
                                       {"aim", "rad", Schema(Schema::Kind::kFloat64)}}),
      "plant.Move: field aim needed, field goal offered");
}

TEST_P(TypeMismatch, IgnoresASchemaWithAnotherFingerprint) {
  StartRobot();

  EXPECT_EQ(WhyRefused(Goal("mm"), Foreigner::Manner::kLying),
            kFrame + "(fields, units or shapes differ)");
}

TEST_P(TypeMismatch, OmitsTheDifferenceForAnUnresponsivePeer) {
  StartRobot();

  EXPECT_EQ(WhyRefused(Goal("m"), Foreigner::Manner::kSilent),
            kFrame + "(fields, units or shapes differ)");
}

INSTANTIATE_TEST_SUITE_P(Over, TypeMismatch, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
