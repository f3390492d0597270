#include <gtest/gtest.h>
#include <tendon/payload/json.h>
#include <tests/core/payload/json/json_error.h>
#include <tests/core/payload/random_value.h>
#include <tests/core/payload/sample_types.h>

#include <cmath>
#include <limits>

namespace sample {
struct Goal {
  JointState target;
  double period = 0;
  Mode mode = Mode::kOff;
  std::uint8_t retries = 0;
  std::chrono::milliseconds timeout{};
  std::string note;
  bool blocking = false;
  std::vector<Point> via;

  bool operator==(const Goal&) const = default;
};
}  // namespace sample

template <>
inline constexpr auto tendon::kPayload<sample::Goal> = tendon::Describe(
    "sample.Goal", tendon::Field{"target", &sample::Goal::target},
    tendon::Field{"period", &sample::Goal::period, "s"}, tendon::Field{"mode", &sample::Goal::mode},
    tendon::Field{"retries", &sample::Goal::retries},
    tendon::Field{"timeout", &sample::Goal::timeout}, tendon::Field{"note", &sample::Goal::note},
    tendon::Field{"blocking", &sample::Goal::blocking},
    tendon::Field{"via", &sample::Goal::via, "m"});

namespace tendon {
namespace {

const std::string kGoal =
    R"({"target":{"position":[0,0,0,0.5,0,0,0],"velocity":[0,0,0,0,0,0,0]},"period":1.5,)"
    R"("mode":"tracking","retries":3,"timeout":0.25,"note":"go","blocking":true,)"
    R"("via":[{"x":1,"y":2,"z":3}]})";

sample::Goal Goal() {
  sample::Goal goal;
  goal.target.position[3] = 0.5;
  goal.period = 1.5;
  goal.mode = sample::Mode::kTracking;
  goal.retries = 3;
  goal.timeout = std::chrono::milliseconds(250);
  goal.note = "go";
  goal.blocking = true;
  goal.via = {{1, 2, 3}};
  return goal;
}

/// Returns kGoal with one passage replaced.
std::string With(const std::string& passage, const std::string& replacement) {
  std::string json = kGoal;
  return json.replace(json.find(passage), passage.size(), replacement);
}

TEST(Json, HasTheFieldsInOrder) { EXPECT_EQ(ToJson(Goal()), kGoal); }

TEST(Json, ReadsHandWrittenJson) {
  const auto goal = FromJson<sample::Goal>(kGoal);

  ASSERT_TRUE(goal) << goal.error().message;
  EXPECT_EQ(*goal, Goal());
}

TEST(Json, NumbersHaveTheShortestExactForm) {
  EXPECT_EQ(ToJson(0.1), "0.1");
  EXPECT_EQ(ToJson(0.1F), "0.1");
  EXPECT_EQ(ToJson(1e300), "1e+300");
  EXPECT_EQ(ToJson(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
  EXPECT_EQ(ToJson(std::int8_t{-128}), "-128");
  for (const double number : {1.0 / 3, 5e-324, 1.7976931348623157e308, -0.0, 123456789.123}) {
    const auto back = FromJson<double>(ToJson(number));
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(*back, number);
  }
}

TEST(Json, NanAndInfinitiesAreStrings) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(ToJson(std::array<double, 3>{std::nan(""), kInfinity, -kInfinity}),
            R"(["nan","inf","-inf"])");
  const auto back = FromJson<std::array<float, 3>>(R"(["nan","inf","-inf"])");
  ASSERT_TRUE(back);
  EXPECT_TRUE(std::isnan((*back)[0]));
  EXPECT_EQ((*back)[1], std::numeric_limits<float>::infinity());
  EXPECT_EQ((*back)[2], -std::numeric_limits<float>::infinity());
}

TEST(Json, DurationsAreSeconds) {
  using std::chrono::nanoseconds;
  EXPECT_EQ(ToJson(nanoseconds(1)), "0.000000001");
  EXPECT_EQ(ToJson(nanoseconds(-1)), "-0.000000001");
  EXPECT_EQ(ToJson(nanoseconds(-1'500'000'000)), "-1.5");
  EXPECT_EQ(ToJson(std::chrono::hours(-2)), "-7200");
  const auto back = FromJson<nanoseconds>("-1.500000001");
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, nanoseconds(-1'500'000'001));
}

TEST(Json, NoneIsNullOrEmpty) {
  EXPECT_EQ(ToJson(None{}), "null");
  for (const char* json : {"null", "{}", "", " \n"}) {
    EXPECT_TRUE(FromJson<None>(json)) << json;
  }
  EXPECT_EQ(ErrorOf<None>("3"), "expected null, got number 3");
  EXPECT_EQ(ErrorOf<None>(R"({"a":1})"), "expected null, got an object");
}

TEST(Json, AStringIsEscaped) {
  const std::string text = "a\"b\\c\n\x01\xc3\xa9";
  EXPECT_EQ(ToJson(text), "\"a\\\"b\\\\c\\n\\u0001\xc3\xa9\"");
  const auto back = FromJson<std::string>(ToJson(text));
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, text);
}

TEST(Json, ReplacesInvalidUtf8) { EXPECT_EQ(ToJson(std::string("\xff")), "\"�\""); }

TEST(Json, AnEnumsValueWithoutANameIsShown) {
  EXPECT_EQ(ToJson(static_cast<sample::Mode>(9)), "9");
}

TEST(Json, EveryKindRoundTrips) {
  std::mt19937 random(10);
  for (int round = 0; round < 200; ++round) {
    sample::Dynamic dynamic;
    sample::Fixed fixed;
    sample::Numbers numbers;
    sample::Randomise(random, dynamic);
    sample::Randomise(random, fixed);
    sample::Randomise(random, numbers);

    const auto dynamic_back = FromJson<sample::Dynamic>(ToJson(dynamic));
    const auto fixed_back = FromJson<sample::Fixed>(ToJson(fixed));
    const auto numbers_back = FromJson<sample::Numbers>(ToJson(numbers));

    ASSERT_TRUE(dynamic_back && fixed_back && numbers_back);
    ASSERT_EQ(*dynamic_back, dynamic);
    ASSERT_EQ(*fixed_back, fixed);
    ASSERT_EQ(*numbers_back, numbers);
  }
}

TEST(FromJson, ErrorsNamePositionExpectationAndInput) {
  const auto error = ErrorOf<sample::Goal>;
  EXPECT_EQ(error(With("0.5", "\"x\"")),
            "target.position[3]: expected a number (rad), got string 'x'");
  EXPECT_EQ(error(With("0.5", "null")), "target.position[3]: expected a number (rad), got null");
  EXPECT_EQ(error(With(":1.5", ":true")), "period: expected a number (s), got true");
  EXPECT_EQ(error(With("\"z\":3", "\"z\":[]")),
            "via[0].z: expected a number (m), got an array of 0");
  EXPECT_EQ(error(With("\"go\"", "5")), "note: expected a string, got number 5");
  EXPECT_EQ(error(With("true", "1")), "blocking: expected true or false, got number 1");
  EXPECT_EQ(error(With(":3,", ":300,")),
            "retries: expected an integer from 0 to 255, got number 300");
  EXPECT_EQ(error(With(":3,", ":-1,")),
            "retries: expected an integer from 0 to 255, got number -1");
  EXPECT_EQ(error(With(":3,", ":2.5,")),
            "retries: expected an integer from 0 to 255, got number 2.5");
  EXPECT_EQ(error(With("0.25", "1e10")),
            "timeout: expected a number of seconds, below 68 years, got number 10000000000");
  EXPECT_EQ(error(With("[0,0,0,0.5,0,0,0]", "[1,2]")),
            "target.position: expected an array of 7 float64 (rad), got an array of 2");
  EXPECT_EQ(error(With("[{\"x\":1,\"y\":2,\"z\":3}]", "{}")),
            "via: expected an array of sample.Point (m), got an object");
  EXPECT_EQ(error("[1]"), "expected an object (sample.Goal), got an array of 1");
  EXPECT_EQ(ErrorOf<float>("1e39"), "expected a number that float32 can hold, got number 1e+39");
  EXPECT_EQ(ErrorOf<bool>("\"" + std::string(100, 'y') + "\""),
            "expected true or false, got string '" + std::string(40, 'y') + "...'");
}

TEST(FromJson, NamesAnUnknownOrMissingKey) {
  const auto error = ErrorOf<sample::Goal>;
  EXPECT_EQ(error(With("\"period\"", "\"preiod\"")),
            "unknown key 'preiod'; did you mean 'period'?");
  EXPECT_EQ(error(With("\"velocity\"", "\"zzz\"")), "target: unknown key 'zzz'");
  EXPECT_EQ(error(With("\"period\":1.5,", "")), "missing key 'period' (float64 in s)");
  EXPECT_EQ(error(With(",\"z\":3", "")), "via[0]: missing key 'z' (float64)");
}

TEST(FromJson, SuggestsASimilarEnumName) {
  EXPECT_EQ(ErrorOf<sample::Mode>("\"trackin\""),
            "expected one of 'off', 'tracking', 'fault', got string 'trackin'; did you mean "
            "'tracking'?");
  EXPECT_EQ(ErrorOf<sample::Mode>("5"), "expected one of 'off', 'tracking', 'fault', got number 5");
}

TEST(FromJson, AnIntegerMayBeWrittenAsARealNumber) {
  EXPECT_EQ(*FromJson<int>("5.0"), 5);
  EXPECT_EQ(*FromJson<int>("1e3"), 1000);
  EXPECT_EQ(*FromJson<std::int64_t>("1e18"), 1'000'000'000'000'000'000);
  EXPECT_EQ(ErrorOf<std::int64_t>("1e30"),
            "expected an integer from -9223372036854775808 to 9223372036854775807, got number "
            "1e+30");
}

TEST(ToJson, ExplainsAnInvalidBody) {
  const auto error = [](const Schema& schema, std::vector<std::byte> body) {
    const auto json = ToJson(schema, body);
    return json ? "accepted" : json.error().message;
  };
  EXPECT_EQ(error(SchemaOf<double>(), std::vector<std::byte>(7)),
            "these 7 bytes are not a valid float64: expected float64, found none");
  EXPECT_EQ(error(SchemaOf<bool>(), {std::byte{2}}),
            "these 1 bytes are not a valid bool: expected bool, found none");
  EXPECT_EQ(error(SchemaOf<double>(), std::vector<std::byte>(9)),
            "these 9 bytes are not a valid float64: there is more data after the end of the value");
}

TEST(ToJson, AcceptsEveryBodyThatDecodeAccepts) {
  std::mt19937 random(11);
  std::vector<std::byte> body;
  int accepted = 0;
  for (int round = 0; round < 3000; ++round) {
    sample::Dynamic value;
    sample::Randomise(random, value);
    Encode(value, body);
    body[random() % body.size()] = static_cast<std::byte>(random());
    if (random() % 4 == 0) body.resize(random() % body.size());
    const bool decodes = Decode(body, value);
    const auto json = ToJson(SchemaOf<sample::Dynamic>(), body);
    if (decodes) {
      ++accepted;
      ASSERT_TRUE(json) << json.error().message;
    }
  }
  EXPECT_GT(accepted, 0);
}

}  // namespace
}  // namespace tendon
