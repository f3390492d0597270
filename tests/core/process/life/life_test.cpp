#include <filesystem>
#include <fstream>
#include <future>

#include "core/process/life/life_fixture.h"
#include "support/plant.h"

namespace {

using tendon::ComponentState;
using tendon::ErrorCode;
using tendon::LifeVerb;
using tendon::message::Classes;
using testing::HasSubstr;

class Life : public LifeFixture {
 protected:
  [[nodiscard]] tendon::Result<Classes> ClassesOf(const std::string& process) {
    return tendon::Wait<Classes>(kLong,
                                 [&](auto handler) { client_->GetClasses(process, handler); });
  }
};

INSTANTIATE_TEST_SUITE_P(Over, Life, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

TEST_P(Life, AComponentIsMadeStartedSuspendedStoppedAndRemovedFromAfar) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp", "{\n  \"brightness\": 0.25\n}")), "");
  EXPECT_EQ(Known("lamp").class_name, "Lamp");
  EXPECT_EQ(Known("lamp").library, "lamps");
  EXPECT_EQ(Known("lamp").configuration, R"({"brightness":0.25})");
  EXPECT_EQ(Known("lamp").state, ComponentState::kConstructed);

  EXPECT_EQ(Reason(Order(LifeVerb::kStart, "lamp")), "");
  EXPECT_EQ(Known("lamp").state, ComponentState::kActive);
  EXPECT_EQ(Reason(Order(LifeVerb::kSuspend, "lamp")), "");
  EXPECT_EQ(Known("lamp").state, ComponentState::kSuspended);
  EXPECT_EQ(Reason(Order(LifeVerb::kRestart, "lamp")), "");
  EXPECT_EQ(Known("lamp").state, ComponentState::kActive);
  EXPECT_EQ(Reason(Order(LifeVerb::kStop, "lamp")), "");
  EXPECT_EQ(Known("lamp").state, ComponentState::kFinished);

  EXPECT_EQ(Reason(Order(LifeVerb::kRemove, "lamp")), "");
  EXPECT_EQ(Known("lamp").name, "");
  EXPECT_EQ(robot_->Find("lamp"), nullptr);
}

TEST_P(Life, AProcessSaysWhatItCanMakeAndWithWhichArguments) {
  const auto before = ClassesOf("robot");
  ASSERT_TRUE(before) << before.error().message;
  EXPECT_TRUE(before->classes.empty());
  EXPECT_THAT(before->plugins, testing::Contains("lamps"));

  ASSERT_EQ(Reason(Load("lamps")), "");

  const auto all = ClassesOf("robot");
  ASSERT_TRUE(all) << all.error().message;
  ASSERT_EQ(all->classes.size(), 6U);
  const tendon::ClassDescription& lamp = all->classes[2];
  EXPECT_EQ(lamp.name, "Lamp");
  EXPECT_EQ(lamp.library, "lamps");
  EXPECT_EQ(lamp.defaults, R"({"brightness":0.5})");
  const auto schema = tendon::Schema::Parse(lamp.configuration);
  ASSERT_TRUE(schema) << schema.error().message;
  EXPECT_EQ(schema->TypeName(), "lamps.LampConfiguration");
  EXPECT_THAT(lamp.configuration, HasSubstr("@ 0 to 1"));
  EXPECT_EQ(ClassesOf("robbot").error().message, "no process 'robbot'; did you mean 'robot'?");
}

TEST_P(Life, ALoadedClassIsFoundWithoutItsLibrary) {
  const tendon::message::LifeOrder order{
      .verb = LifeVerb::kCreate, .process = "robot", .component = "lamp", .class_name = "Lamp"};
  EXPECT_EQ(Reason(Steer(*client_, order)),
            "no library that process 'robot' has loaded has a class 'Lamp'; load one that has it, "
            "or name it");
  ASSERT_EQ(Reason(Load("lamps")), "");

  EXPECT_EQ(Reason(Steer(*client_, order)), "");

  EXPECT_EQ(Known("lamp").library, "lamps");
}

TEST_P(Life, WhatTheProcessRefusesIsPassedOnAndChangesNothing) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  robot_->Add<plant::Plant>("plant");
  ASSERT_TRUE(EventuallyTrue([&] { return !Known("plant").name.empty(); }));
  const auto before = gcm().catalog().ContentHash();

  EXPECT_THAT(Reason(Load("lamp")), HasSubstr("no plug-in 'lamp'; did you mean 'lamps'?"));
  EXPECT_THAT(Reason(Load("../lamps")), HasSubstr("plug-in name '../lamps' has '.' at 1"));
  EXPECT_EQ(Reason(Create("Lampe", "other")),
            "no component class 'Lampe'; did you mean 'Lamp'? (plug-in lamps.so)");
  EXPECT_EQ(
      Reason(Create("Lamp", "other", R"({"brightness": 7})")),
      "component 'other' (class Lamp): brightness: expected a number from 0 to 1, got number 7 "
      "(plug-in lamps.so)");
  EXPECT_EQ(Reason(Create("Lamp", "other", R"({"brightness": 0})")),
            "component 'other' (class Lamp): its constructor failed: a black lamp is none (plug-in "
            "lamps.so)");
  EXPECT_EQ(Reason(Create("Lamp", "a b")),
            "component name 'a b' has ' ' at 2; allowed: letters digits _ - (max 64)");
  EXPECT_EQ(Reason(Create("Lamp", "lamp")),
            "component 'lamp' already exists in process 'robot'; choose another name, or remove it "
            "first");
  EXPECT_EQ(Reason(Order(LifeVerb::kStop, "lamp")),
            "component 'lamp' is constructed, not active; there is nothing to stop");
  EXPECT_EQ(Reason(Order(LifeVerb::kRemove, "plant")),
            "component 'plant' cannot be removed from afar, for the program of process 'robot' has "
            "made it by itself; it can be started and stopped");
  EXPECT_THAT(Reason(Order(LifeVerb::kStart, "lam")),
              HasSubstr("no component 'robot/lam'; did you mean 'lamp'?"));

  EXPECT_EQ(gcm().catalog().ContentHash(), before);
  const auto history = tendon::Wait<tendon::message::History>(
      kLong, [&](auto handler) { client_->GetHistory(handler); });
  EXPECT_EQ(history->entries.size(), 1U);
}

TEST_P(Life, AProcessWithoutPlugInsMakesNothingButStartsWhatItHas) {
  const auto desk = Start("desk");
  desk->Add<plant::Plant>("plant");
  ASSERT_TRUE(
      EventuallyTrue([&] { return client_->catalog().FindComponent("desk", "plant") != nullptr; }));

  EXPECT_EQ(Reason(Steer(*client_, {.verb = LifeVerb::kLoad, .process = "desk", .library = "x"})),
            "process 'desk' makes no components from afar, for its program has none of the classes "
            "of plug-ins; the program lcm has");
  EXPECT_EQ(
      Reason(Steer(*client_, {.verb = LifeVerb::kStart, .process = "desk", .component = "plant"})),
      "");
  EXPECT_EQ(desk->Find("plant")->state(), ComponentState::kActive);
}

TEST_P(Life, APlugInThatTakesItsTimeHoldsUpNothingElse) {
  const tendon::test::Folder folder;
  const std::string file = (folder.path() / "open").string();
  ASSERT_EQ(Reason(Load("lamps")), "");
  std::promise<tendon::Result<void>> made;
  client_->Steer({.verb = LifeVerb::kCreate,
                  .process = "robot",
                  .component = "gate",
                  .class_name = "Gate",
                  .configuration = R"({"file": ")" + file + "\"}"},
                 [&](const auto& result) { made.set_value(result); });
  ASSERT_TRUE(EventuallyTrue([&] { return std::filesystem::exists(file + ".reached"); }));

  const auto late = Steer(*client_, {.verb = LifeVerb::kCreate,
                                     .process = "robot",
                                     .component = "lamp",
                                     .class_name = "Lamp",
                                     .patience = std::chrono::milliseconds(1)});
  EXPECT_FALSE(late);  // nobody waits for it any more
  robot_->Add<plant::Plant>("plant");
  EXPECT_TRUE(EventuallyTrue([&] { return !Known("plant").name.empty(); }));
  std::ofstream(file) << "now";
  EXPECT_EQ(Reason(made.get_future().get()), "");
  EXPECT_EQ(Reason(Create("Lamp", "after")), "");

  EXPECT_EQ(Known("gate").class_name, "Gate");
  EXPECT_EQ(Known("lamp").name, "");  // nor was it made late
}

TEST_P(Life, AnOrderForAnEarlierInstanceIsNotGivenToTheNextOne) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");

  EXPECT_EQ(Reason(Steer(*client_, {.verb = LifeVerb::kStart,
                                    .process = "robot",
                                    .instance = robot_->instance() + 1,
                                    .component = "lamp"})),
            "process 'robot' was started anew meanwhile: nothing was done; look at it and ask "
            "again");

  EXPECT_EQ(robot_->Find("lamp")->state(), ComponentState::kConstructed);
}

TEST_P(Life, AViewerIsDenied) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  const auto viewer = NewClient(tendon::Role::kViewer);

  const auto started =
      Steer(*viewer, {.verb = LifeVerb::kStart, .process = "robot", .component = "lamp"});

  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().code, ErrorCode::kDenied);
  EXPECT_EQ(robot_->Find("lamp")->state(), ComponentState::kConstructed);
  const auto all =
      tendon::Wait<Classes>(kLong, [&](auto handler) { viewer->GetClasses("robot", handler); });
  EXPECT_TRUE(all) << all.error().message;
}

TEST_P(Life, AComponentConfiguredAnewKeepsItsConnections) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_EQ(Reason(Create("Switch", "switch")), "");
  ASSERT_TRUE(robot_->Connect({"switch", "Lamp"}, {"lamp", "Control"}));
  ASSERT_EQ(Reason(Order(LifeVerb::kStart, "lamp")), "");
  EXPECT_EQ(Reason(Configure("lamp", R"({"brightness": 0.75})")),
            "component 'lamp' is active; stop it first to configure it anew");
  ASSERT_EQ(Reason(Order(LifeVerb::kStop, "lamp")), "");
  EXPECT_THAT(Reason(Configure("lamp", R"({"brightness": 7})")), HasSubstr("from 0 to 1"));
  EXPECT_EQ(Known("lamp").configuration, "");

  EXPECT_EQ(Reason(Configure("lamp", R"({"brightness": 0.75})")), "");

  EXPECT_EQ(Known("lamp").configuration, R"({"brightness":0.75})");
  EXPECT_TRUE(EventuallyActive(*robot_, 1));
}

}  // namespace
