#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "gcm_console/output/json_schema.h"
#include "gcm_console/system_fixture.h"
#include "support/locales.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A component in a real process, created with a value for one parameter and not started.
class SetVerbTest : public SystemFixture {
 protected:
  void SetUp() override {
    StartGcm();
    robot = std::make_unique<Program>(Program::Words{Binary("lcm"), "--name", "robot", "--gcm",
                                                     address, "--timeout", kTestTimeout});
    ASSERT_TRUE(EventuallySays({"ls"}, "robot\talive")) << robot->err();
    const Outcome created = Gcm({"create", "SimulatedArm", "robot/arm", "--library",
                                 "simulated_arm", "--arg", R"({"noise": 0.001})"});
    ASSERT_EQ(created.exit_code, program::kOk) << created.err;
  }
  Outcome Set(const Program::Words& words) const {
    Program::Words all{"set", "robot/arm"};
    all.insert(all.end(), words.begin(), words.end());
    return Gcm(all);
  }
  /// Returns the configuration that the process stores.
  json Told() const {
    const std::string file = (home.path() / "told.json").string();
    const Outcome saved = Gcm({"save", file});
    EXPECT_EQ(saved.exit_code, program::kOk) << saved.err;
    const json system = json::parse(std::ifstream(file), nullptr, false);
    return system["processes"][0]["components"][0]["configuration"];
  }

  std::unique_ptr<Program> robot;
};

TEST_F(SetVerbTest, SetChangesOneParameterAndKeepsTheOthers) {
  EXPECT_EQ(Set({"bandwidth", "40"}).out, "robot/arm bandwidth\tset from 50 to 40\n");
  EXPECT_EQ(Told(), json::parse(R"({"noise": 0.001, "bandwidth": 40})"));

  EXPECT_EQ(Set({"home[1]", "-0.5"}).exit_code, program::kOk);
  EXPECT_EQ(Told()["home"][1], -0.5);
  EXPECT_EQ(Told()["home"].size(), 7U);
  EXPECT_EQ(Set({"noise", "0"}).out, "robot/arm noise\tset from 0.001 to 0\n");
  EXPECT_EQ(Set({"noise", "0"}).out, "robot/arm noise\tis 0 already\n");

  EXPECT_THAT(Gcm({"history"}).out, HasSubstr("configure robot/arm: bandwidth default -> 40\n"));
  EXPECT_EQ(Gcm({"undo"}).out, "undone: configure robot/arm: noise 0.001 -> 0\n");
  EXPECT_EQ(Told()["noise"], 0.001);
  EXPECT_EQ(Gcm({"undo", "2"}).exit_code, program::kOk);
  EXPECT_EQ(Told(), json::parse(R"({"noise": 0.001})"));
}

TEST_F(SetVerbTest, ReadsNumbersAlikeInAllLocales) {
  tendon::test::Locales locales;
  for (const std::string& name : tendon::test::Locales::Names()) {
    ASSERT_TRUE(locales.Use(name)) << "localedef did not make " << name;
    const std::map<std::string, std::string> language{{"LC_ALL", name},
                                                      {"LOCPATH", locales.path()}};
    const auto in_language = [&](Program::Words words) {
      words.insert(words.begin(), {Binary("gcm"), "--gcm", address, "--timeout", kTestTimeout});
      return RunProgram(words, language);
    };

    EXPECT_EQ(in_language({"set", "robot/arm", "noise", "0.25"}).out,
              "robot/arm noise\tset from 0.001 to 0.25\n")
        << name;
    const Outcome refused = in_language({"set", "robot/arm", "noise", "0,125"});
    EXPECT_EQ(refused.exit_code, program::kUsage) << name;
    EXPECT_THAT(refused.err, HasSubstr("'0,125'; write 0.125: use a point as the decimal sign"));
    EXPECT_THAT(in_language({"watch", "robot/arm/state.Joints", "--hz", "0,5"}).err,
                HasSubstr("'0,5'; write 0.5: use a point as the decimal sign"));
    EXPECT_EQ(in_language({"set", "robot/arm", "noise", "0.001"}).out,
              "robot/arm noise\tset from 0.25 to 0.001\n")
        << name;
  }
}

TEST_F(SetVerbTest, ADryRunChecksEverythingAndChangesNothing) {
  EXPECT_EQ(Set({"noise", "0.5", "--dry-run"}).out,
            "robot/arm noise\twould be set from 0.001 to 0.5\n");
  EXPECT_EQ(Told()["noise"], 0.001);
  EXPECT_EQ(Set({"noise", "loud", "--dry-run"}).exit_code, program::kUsage);
}

TEST_F(SetVerbTest, RefusesToConfigureAnActiveComponent) {
  ASSERT_EQ(Gcm({"start", "robot/arm"}).exit_code, program::kOk);
  const std::string refusal =
      "gcm: component 'arm' is active; stop it first to configure it again: gcm stop "
      "robot/arm\n";
  for (const Program::Words& words : {Program::Words{"noise", "0"}, {"noise", "0", "--dry-run"}}) {
    const Outcome refused = Set(words);
    EXPECT_EQ(refused.err, refusal);
    EXPECT_EQ(refused.exit_code, program::kRefused);
  }
  EXPECT_EQ(Told()["noise"], 0.001);

  ASSERT_EQ(Gcm({"stop", "robot/arm"}).exit_code, program::kOk);
  EXPECT_EQ(Set({"noise", "0"}).exit_code, program::kOk);
}

TEST_F(SetVerbTest, ListsParametersWithoutAValue) {
  EXPECT_THAT(Set({}).out, HasSubstr("noise\t0.001\tfloat64\trad\t"));
  EXPECT_THAT(Set({}).out, HasSubstr("bandwidth\t50\tfloat64\trad/s\t"));
  EXPECT_EQ(Set({"noise"}).out,
            "noise\t0.001\tfloat64\trad\t0 to 1\tStandard deviation of a measured position.\n");
  EXPECT_THAT(Set({"home[2]"}).out, HasSubstr("home[2]\t0\tfloat64\trad\t"));

  const json told = json::parse(Set({"--json"}).out, nullptr, false);
  const json schema = json::parse(std::ifstream(std::string(TENDON_JSON_SCHEMAS) + "/act/set.json"),
                                  nullptr, false);
  EXPECT_EQ(MisfitOf(told, schema), "");
  EXPECT_EQ(told["parameters"].size(), 7U);
}

TEST_F(SetVerbTest, ExplainsEachMistake) {
  struct Mistake {
    Program::Words words;
    std::string sentence;
    int exit_code;
  };
  const Mistake mistakes[] = {
      {{"nois", "0"}, "robot/arm: no parameter 'nois'; did you mean 'noise'?", program::kNotFound},
      {{"home[9]", "0"},
       "'home' has 7 elements, numbered from 0; there is no element 9",
       program::kNotFound},
      {{"noise.x", "0"}, "'noise' is float64 and has no fields", program::kNotFound},
      {{"home[", "0"}, "'home[' does not name a parameter", program::kUsage},
      {{"noise", "loud"},
       "noise: expected float64, got 'loud'; write a number in digits",
       program::kUsage},
      {{"noise", "\"loud\""}, "noise: expected a number (rad), got string 'loud'", program::kUsage},
      {{"home", "[1, 2]"}, "home: expected", program::kUsage},
      {{"bandwidth", "-1"},
       "bandwidth: expected a number from 0.001 to 500 (rad/s), got number -1",
       program::kUsage},
      {{"home[1]", "2"}, "home[1] is 2, expected -1.7628 to 1.7628 rad", program::kRefused},
  };
  for (const Mistake& one : mistakes) {
    const Outcome outcome = Set(one.words);
    EXPECT_THAT(outcome.err, HasSubstr(one.sentence));
    EXPECT_EQ(outcome.exit_code, one.exit_code) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_EQ(Told(), json::parse(R"({"noise": 0.001})"));
  EXPECT_THAT(Gcm({"set", "robot/arn", "noise", "0"}).err,
              HasSubstr("no component 'robot/arn'; did you mean 'arm'?"));
  EXPECT_EQ(Gcm({"set", "robot/arm", "noise", "0", "--read-only"}).exit_code, program::kDenied);
}

TEST_F(SetVerbTest, ConcurrentSetsDoNotOverwriteEachOther) {
  std::vector<std::unique_ptr<Program>> persons;
  const std::vector<std::string> parameters{"bandwidth", "noise", "home[1]", "home[2]"};
  for (const std::string& parameter : parameters) {
    persons.push_back(std::make_unique<Program>(Program::Words{Binary("gcm"), "--gcm", address,
                                                               "--timeout", kTestTimeout, "set",
                                                               "robot/arm", parameter, "0.25"}));
  }

  std::vector<int> exit_codes;
  for (const auto& person : persons) exit_codes.push_back(person->Wait().value_or(-1));

  int done = 0;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const int exit_code = exit_codes[i];
    const std::string err = persons[i]->err();
    const std::string now = Set({parameters[i]}).out;
    if (exit_code == program::kOk) {
      ++done;
      EXPECT_THAT(now, HasSubstr("\t0.25\t"));
      continue;
    }
    EXPECT_EQ(exit_code, program::kRefused);
    EXPECT_THAT(err, testing::AnyOf(HasSubstr("was changed meanwhile"),
                                    HasSubstr("is being changed by another request")));
    EXPECT_THAT(now, testing::Not(HasSubstr("\t0.25\t")));
  }
  EXPECT_GE(done, 1);
}

TEST_F(SetVerbTest, CompletesParameterNames) {
  const auto complete = [this](const std::string& word) {
    return RunProgram({Binary("gcm"), "complete", "--gcm", address, "set", "robot/arm", word}).out;
  };
  // The completion gives up soon, so that it does not delay the user. Tries again.
  EXPECT_TRUE(
      EventuallyTrue([&] { return complete("b") == "bandwidth\n"; }, std::chrono::minutes(2)))
      << complete("b");
  EXPECT_EQ(complete("q"), "");
}

}  // namespace
