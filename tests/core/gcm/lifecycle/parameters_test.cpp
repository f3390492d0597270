#include <gtest/gtest.h>
#include <tendon/gcm/lifecycle/parameters.h>
#include <tendon/payload/schema.h>

#include <string>

namespace tendon {
namespace {

/// Returns a class whose configuration has nested structures, a list, a text and an enumeration.
ClassDescription Servo() {
  return {.name = "Servo",
          .library = "servo",
          .configuration = R"(struct servo.Configuration {
  gain: struct servo.Gain {
    # Of the error.
    p: float64 in 1/s
    limits: float64[2]
  }
  mode: enum servo.Mode {
    off = 0
    on = 1
  }
  label: string
  joints: struct servo.Joint {
    name: string
  }[]
}
)",
          .defaults = R"({"gain": {"p": 1.0, "limits": [-1.0, 1.0]}, "mode": "off", "label": "",
                          "joints": [{"name": "elbow"}]})"};
}

std::string Told(const std::string& told, const std::string& name, const std::string& value) {
  const auto changed = ChangeParameter(Servo(), told, name, value);
  return changed ? changed->configuration : changed.error().message;
}

TEST(Parameters, AreTheFieldsThatAreNotStructures) {
  const auto all = ParametersOf(Servo(), R"({"gain": {"p": 2.0}})");

  ASSERT_TRUE(all) << all.error().message;
  ASSERT_EQ(all->size(), 5U);
  const Parameter& gain = all->front();
  EXPECT_EQ(gain.name, "gain.p");
  EXPECT_EQ(gain.type, "float64");
  EXPECT_EQ(gain.unit, "1/s");
  EXPECT_EQ(gain.help, "Of the error.");
  EXPECT_EQ(gain.value, "2.0");
  EXPECT_EQ(all->at(1).value, "[-1.0,1.0]");
  EXPECT_EQ(all->at(4).name, "joints");
}

TEST(Parameters, RefusesInvalidUtf8) {
  EXPECT_EQ(Told("", "label", "\xff"), R"(label: '\xff' is not valid UTF-8)");
}

TEST(Parameters, LimitsTheNestingOfRemoteJsonTo64) {
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  const std::string refusal =
      "class 'Servo' has a configuration that cannot be read: nesting deeper than 64";
  ClassDescription hostile = Servo();
  hostile.defaults = "{\"label\": " + deep + "}";

  EXPECT_EQ(ParametersOf(hostile, "").error().message, refusal);
  EXPECT_EQ(ParametersOf(Servo(), "{\"label\": " + deep + "}").error().message, refusal);
  EXPECT_TRUE(Told("", "joints", deep).starts_with("joints: expected "));
  EXPECT_TRUE(Told("", "joints", deep).ends_with(": nesting deeper than 64"));
}

TEST(Parameters, FindsTheParametersOfAPart) {
  EXPECT_EQ(ParametersAt(Servo(), "", "gain")->size(), 2U);
  const auto element = ParametersAt(Servo(), "", "gain.limits[1]");
  ASSERT_TRUE(element) << element.error().message;
  ASSERT_EQ(element->size(), 1U);
  EXPECT_EQ(element->front().value, "1.0");
  EXPECT_EQ(element->front().type, "float64");
}

TEST(Parameters, KeepsEarlierValuesAndAddsTheChangedOne) {
  EXPECT_EQ(Told("", "gain.p", "3"), R"({"gain":{"p":3}})");
  EXPECT_EQ(Told(R"({"label": "left"})", "gain.p", "3"), R"({"label":"left","gain":{"p":3}})");
}

TEST(Parameters, SetsAListAsAWhole) {
  EXPECT_EQ(Told("", "gain.limits[0]", "-2"), R"({"gain":{"limits":[-2,1.0]}})");
  EXPECT_EQ(Told("", "joints[0].name", "wrist"), R"({"joints":[{"name":"wrist"}]})");
}

TEST(Parameters, TextsAndChoicesNeedNoQuotes) {
  EXPECT_EQ(Told("", "mode", "on"), R"({"mode":"on"})");
  EXPECT_EQ(Told("", "mode", "\"on\""), R"({"mode":"on"})");
  EXPECT_EQ(Told("", "label", "12"), R"({"label":"12"})");
}

TEST(Parameters, AnErrorNamesThePlaceAndTheExpectation) {
  EXPECT_EQ(Told("", "gian", "1"), "no parameter 'gian'; did you mean 'gain'?");
  EXPECT_EQ(Told("", "gain.velocity.x", "1"),
            "no parameter 'velocity' in 'gain'; there is p, limits");
  EXPECT_EQ(Told("", "joints[1].name", "x"),
            "'joints' has 1 elements, numbered from 0; there is no element 1");
  EXPECT_EQ(Told("", "gain[0]", "1"), "'gain' is servo.Gain and has no elements");
  EXPECT_NE(Told("", "mode", "onn").find("mode: "), std::string::npos) << Told("", "mode", "onn");
  EXPECT_EQ(Told("", "gain.p", "true"),
            "gain.p: expected float64, got 'true'; write a number in digits");
  for (const char* name : {"", ".", "[0]", "gain.", "gain..p", "gain.limits[", "gain.limits[-1]",
                           "gain.limits[1]x", "gain.limits[99999999999999999999]"}) {
    EXPECT_NE(Told("", name, "1").find("does not name a parameter"), std::string::npos) << name;
  }
}

TEST(Parameters, AClassWithoutAConfigurationHasNone) {
  const ClassDescription plain{.name = "Counter",
                               .library = "counter",
                               .configuration = Schema().TextWithHelp(),
                               .defaults = "null"};
  EXPECT_EQ(ParametersOf(plain, "").error().message, "class 'Counter' takes no configuration");
}

}  // namespace
}  // namespace tendon
