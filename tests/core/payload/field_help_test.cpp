#include <gtest/gtest.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/payload/json.h>

#include <chrono>
#include <cmath>

namespace arm {

template <int kVariant>
struct Goal {
  std::array<double, 2> speed{};
  int retries = 0;
  std::chrono::milliseconds timeout{};
  std::string note;
};

}  // namespace arm

namespace tendon {

template <>
inline constexpr auto kPayload<arm::Goal<0>> =
    Describe("arm.Goal", Field{"speed", &arm::Goal<0>::speed, "rad/s"},
             Field{"retries", &arm::Goal<0>::retries}, Field{"timeout", &arm::Goal<0>::timeout},
             Field{"note", &arm::Goal<0>::note});

template <>
inline constexpr auto kPayload<arm::Goal<1>> = Describe(
    "arm.Goal", Field{"speed", &arm::Goal<1>::speed, "rad/s"}.Within(0, 2.5).Help("Of each joint."),
    Field{"retries", &arm::Goal<1>::retries}.Within(-1, 3),
    Field{"timeout", &arm::Goal<1>::timeout}.Within(0.25, HUGE_VAL),
    Field{"note", &arm::Goal<1>::note}.Help("# @ shown to the operator"));

template <>
inline constexpr auto kPayload<arm::Goal<2>> =
    Describe("arm.Goal", Field{"speed", &arm::Goal<2>::speed, "deg/s"}.Within(0, 2.5),
             Field{"retries", &arm::Goal<2>::retries}, Field{"timeout", &arm::Goal<2>::timeout},
             Field{"note", &arm::Goal<2>::note});

namespace {

constexpr std::string_view kText = R"(struct arm.Goal {
  # Of each joint.
  @ 0 to 2.5
  speed: float64[2] in rad/s
  @ -1 to 3
  retries: int32
  @ 0.25 to inf
  timeout: duration
  # # @ shown to the operator
  note: string
})";

std::string ErrorOfGoal(std::string_view json) {
  const auto goal = FromJson<arm::Goal<1>>(json);
  return goal ? "accepted" : goal.error().message;
}

std::string JsonOf(const std::string& speed, const std::string& retries,
                   const std::string& timeout) {
  return R"({"speed":)" + speed + R"(,"retries":)" + retries + R"(,"timeout":)" + timeout +
         R"(,"note":""})";
}

TEST(FieldHelp, ReachesTheSchema) {
  const auto& fields = SchemaOf<arm::Goal<1>>().fields();

  EXPECT_EQ(fields[0].help, "Of each joint.");
  EXPECT_EQ(fields[0].range, (Range{0, 2.5}));
  EXPECT_EQ(fields[2].range, (Range{0.25, HUGE_VAL}));
  EXPECT_EQ(fields[3].range, std::nullopt);
}

TEST(FieldHelp, IsSentInASeparateText) {
  EXPECT_EQ(SchemaOf<arm::Goal<1>>().TextWithHelp(), kText);

  const auto read = Schema::Parse(kText);

  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->TextWithHelp(), kText);
  EXPECT_EQ(read->Text(), SchemaOf<arm::Goal<0>>().Text());
}

TEST(FieldHelp, IsNotPartOfTheType) {
  EXPECT_EQ(FingerprintOf<arm::Goal<1>>(), FingerprintOf<arm::Goal<0>>());
  EXPECT_EQ(SchemaOf<arm::Goal<1>>(), SchemaOf<arm::Goal<0>>());
  EXPECT_EQ(FirstDifference(SchemaOf<arm::Goal<1>>(), SchemaOf<arm::Goal<0>>()), std::nullopt);
}

TEST(FieldHelp, LeavesUnitsPartOfTheType) {
  EXPECT_NE(FingerprintOf<arm::Goal<2>>(), FingerprintOf<arm::Goal<1>>());
}

TEST(FieldHelp, IsACommentInARosMessage) {
  EXPECT_EQ(RosMessage(SchemaOf<arm::Goal<1>>()).substr(0, 85),
            "# Of each joint.\n"
            "float64[2] speed  # rad/s, 0 to 2.5\n"
            "int32 retries  # -1 to 3\n"
            "builtin");
}

TEST(FieldHelp, RefusesMalformedHelpWithItsPosition) {
  const auto error = [](const std::string& line, const std::string& type) {
    const auto schema = Schema::Parse("struct a.B {\n  " + line + "\n  x: " + type + "\n}");
    return schema ? "accepted" : schema.error().message;
  };
  EXPECT_EQ(error("# text", "string"), "accepted");
  EXPECT_EQ(error("#", "string"), "schema line 2 column 4: expected a line of help");
  EXPECT_EQ(error("# ends with a space ", "string"),
            "schema line 2 column 4: expected a line of help");
  EXPECT_EQ(error("# \x1b[2J", "string"), "schema line 2 column 4: expected a line of help");
  EXPECT_EQ(error("# " + std::string(201, 'x'), "string"),
            "schema line 2 column 4: expected a line of help");
  EXPECT_EQ(error("@ 1 to 1", "int32[][3]"), "accepted");
  for (const char* bad : {"@ ", "@ 1", "@ 2 to 1", "@ nan to 1", "@ 0 to nan", "@ 0 to 1 m",
                          "@ 0 to 1e999", "@ 0  to 1"}) {
    EXPECT_EQ(error(bad, "int32"), "schema line 2 column 4: expected a range, like 0 to 2.5")
        << bad;
  }
  for (const char* type : {"string", "bool", "struct a.C {\n}", "enum a.D {\n a = 1\n}"}) {
    EXPECT_NE(error("@ 0 to 1", type).find("only a number can have a range"), std::string::npos)
        << type;
  }
}

TEST(FieldRange, IsCheckedForJsonInput) {
  EXPECT_EQ(ErrorOfGoal(JsonOf("[0,2.5]", "3", "0.25")), "accepted");
  EXPECT_EQ(ErrorOfGoal(JsonOf("[0,2.6]", "3", "1")),
            "speed[1]: expected a number from 0 to 2.5 (rad/s), got number 2.6");
  EXPECT_EQ(ErrorOfGoal(JsonOf("[-0.1,0]", "3", "1")),
            "speed[0]: expected a number from 0 to 2.5 (rad/s), got number -0.1");
  EXPECT_EQ(ErrorOfGoal(JsonOf("[\"nan\",0]", "3", "1")),
            "speed[0]: expected a number from 0 to 2.5 (rad/s), got string 'nan'");
  EXPECT_EQ(ErrorOfGoal(JsonOf("[0,0]", "4", "1")),
            "retries: expected an integer from -1 to 3, got number 4");
  EXPECT_EQ(ErrorOfGoal(JsonOf("[0,0]", "-1", "0.2")),
            "timeout: expected a number of seconds from 0.25 to inf, got number 0.2");
}

TEST(FieldRange, IsCheckedWithOnlyASchema) {
  const auto schema = Schema::Parse(kText);
  ASSERT_TRUE(schema);

  const auto body = FromJson(*schema, JsonOf("[3,0]", "0", "1"));

  ASSERT_FALSE(body);
  EXPECT_EQ(body.error().message, ErrorOfGoal(JsonOf("[3,0]", "0", "1")));
}

TEST(FieldRange, IsNotCheckedByTheCodec) {
  arm::Goal<1> goal;
  goal.speed = {7, std::nan("")};
  std::vector<std::byte> body;

  Encode(goal, body);

  EXPECT_TRUE(Decode(body, goal));
  EXPECT_EQ(ToJson(goal), JsonOf("[7,\"nan\"]", "0", "0"));
}

}  // namespace
}  // namespace tendon
