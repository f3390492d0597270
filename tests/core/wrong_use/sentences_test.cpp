#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <memory>
#include <string>

#include "core/task/scripted.h"
#include "support/refusal.h"

// Tests of mistakes in the wiring of components. Each mistake has its own message, which says what
// is wrong, where, what was found, and what to do. The numbers are from the first table in this
// folder's README.md.

namespace {

using tendon::InterfaceName;
using tendon::LocalManager;
using tendon::test::Refusal;
using tendon_test::Callback;
using tendon_test::Client;
using tendon_test::Periodic;
using tendon_test::Threadless;
using testing::MatchesRegex;
using namespace std::chrono_literals;

template <typename T>
std::string Refused(const tendon::Result<T>& result) {
  return result ? "it was not refused" : result.error().message;
}

TEST(NullComponent, IsRefused) {
  LocalManager manager;

  EXPECT_EQ(Refusal([&] { manager.Add(nullptr, {}); }), "LocalManager::Add: null component");
  EXPECT_TRUE(manager.components().empty());
}

/// A name that is not allowed for any kind of object.
struct BadName {
  std::string name;
  std::string after_what;  // the text after "component name "
};

struct InvalidName : testing::TestWithParam<BadName> {
  void Expect(const std::string& what, const std::string& found) {
    EXPECT_EQ(found, what + " name " + GetParam().after_what);
  }
};

TEST_P(InvalidName, IsRefusedWithTheRule) {
  /// Adds one member of the requested kind with this name.
  class Named final : public tendon::Task {
   public:
    Named(const std::string& sort, const std::string& name) : Task("arm") {
      auto& provided = AddProvidedInterface("Control");
      auto& required = AddRequiredInterface("Robot");
      if (sort == "provided interface") AddProvidedInterface(name);
      if (sort == "required interface") AddRequiredInterface(name);
      if (sort == "state table") AddStateTable(name);
      if (sort == "column") state_table().Add(number_, name);
      if (sort == "command") provided.AddCommandVoid(&Named::Stop, this, name);
      if (sort == "event") provided.AddEvent(stopped_, name);
      if (sort == "function") required.AddFunction(stop_, name);
      if (sort == "event handler") required.AddEventHandlerVoid(&Named::Stop, this, name);
    }

   private:
    void Run() override {}
    void Stop() {}
    double number_ = 0.0;
    tendon::VoidEvent stopped_;
    tendon::VoidFunction stop_;
  };
  const std::string& name = GetParam().name;
  LocalManager manager;

  Expect("component", Refusal([&] { manager.Add<Threadless>(name); }));
  for (const std::string sort : {"provided interface", "required interface", "state table",
                                 "column", "command", "event", "function", "event handler"}) {
    Expect(sort, Refusal([&] { const Named named(sort, name); }));
  }
  EXPECT_TRUE(manager.components().empty());
}

const std::string kRule = "; allowed: letters digits _ - (max 64)";
INSTANTIATE_TEST_SUITE_P(
    Names, InvalidName,
    testing::Values(BadName{"", "is empty"}, BadName{"a b", "'a b' has ' ' at 2" + kRule},
                    BadName{"arm/left", "'arm/left' has '/' at 4" + kRule},
                    BadName{"a\n", "'a\\x0a' has '\\x0a' at 2" + kRule},
                    BadName{std::string("a\0b", 3), "'a\\x00b' has '\\x00' at 2" + kRule},
                    BadName{"\xff\xfe", "'\\xff\\xfe' has '\\xff' at 1" + kRule},
                    BadName{"arm.1", "'arm.1' has '.' at 4" + kRule},
                    BadName{std::string(300, 'a'),
                            "'aaaaaaaaaaaaaaaaaaaa...' has 300 characters" + kRule}));

/// Adds a member with the same name twice.
class Twice final : public tendon::Task {
 public:
  explicit Twice(const std::string& sort) : Task("arm") {
    auto& provided = AddProvidedInterface("Control");
    auto& required = AddRequiredInterface("Robot");
    provided.AddCommandVoid(&Twice::Stop, this, "Stop");
    required.AddFunction(stop_, "Stop");
    AddStateTable("more");
    state_table().Add(number_, "Number");
    if (sort == "interface") AddProvidedInterface("Control");
    if (sort == "other side") AddRequiredInterface("Control");
    if (sort == "reserved") AddProvidedInterface("state-more");
    if (sort == "command") provided.AddCommandVoid(&Twice::Stop, this, "Stop");
    if (sort == "event") provided.AddEvent(stopped_, "Stop");
    if (sort == "handler") required.AddEventHandlerVoid(&Twice::Stop, this, "Stop");
    if (sort == "table") AddStateTable("more");
    if (sort == "column") state_table().Add(other_, "Number");
    if (sort == "variable") state_table().Add(number_, "Again");
  }

 private:
  void Run() override {}
  void Stop() {}
  double number_ = 0.0;
  double other_ = 0.0;
  tendon::VoidEvent stopped_;
  tendon::VoidFunction stop_;
};

TEST(DuplicateName, IsRefusedWithThePositionOfTheFirst) {
  const auto thrown = [](const std::string& sort) { return Refusal([&] { Twice twice(sort); }); };
  const std::string here = " .added at sentences_test.cpp:[0-9]+.";

  EXPECT_THAT(thrown("interface"),
              MatchesRegex("interface 'Control' already exists in 'arm'" + here));
  EXPECT_THAT(thrown("other side"),
              MatchesRegex("interface 'Control' already exists in 'arm'" + here));
  EXPECT_THAT(thrown("command"),
              MatchesRegex("command 'Stop' already exists in interface 'Control'" + here));
  EXPECT_THAT(thrown("event"),
              MatchesRegex("event 'Stop' already exists in interface 'Control'" + here));
  EXPECT_THAT(thrown("handler"),
              MatchesRegex("event handler 'Stop' already exists in interface 'Robot'" + here));
  EXPECT_EQ(
      thrown("reserved"),
      "interface 'state-more' of 'arm': the names state and state-... belong to state tables");
  EXPECT_EQ(thrown("table"), "state table 'more' already exists in 'arm'; choose another name");
  EXPECT_EQ(thrown("column"), "state table 'state' has a column 'Number' already");
  EXPECT_EQ(thrown("variable"),
            "the variable of column 'Again' is column 'Number' of state table 'state' already");
}

TEST(DuplicateName, OfAComponentKeepsTheFirst) {
  LocalManager manager;
  auto& first = manager.Add<Threadless>("arm");

  EXPECT_THAT(Refusal([&] { manager.Add<Threadless>("arm"); }),
              MatchesRegex("component 'arm' already exists in this process .added at "
                           "sentences_test.cpp:[0-9]+.; choose another name"));
  EXPECT_EQ(manager.Find("arm"), &first);
}

/// Adds a member when the test requests it.
class Late final : public tendon::CallbackTask {
 public:
  explicit Late(std::string name) : CallbackTask(std::move(name)) {}

  void AddProvided() { AddProvidedInterface("More"); }
  void AddRequired() { AddRequiredInterface("More"); }
  void AddTable() { AddStateTable("more"); }
  void AddColumn() { state_table().Add(number_, "Number"); }
  void AddCommand() { control_.AddCommandVoid(&Late::Stop, this, "Stop"); }
  void AddEvent() { control_.AddEvent(stopped_, "Stopped"); }
  void AddFunction() { robot_.AddFunction(stop_, "Stop"); }

 private:
  void Run() override {}
  void Stop() {}
  tendon::ProvidedInterface& control_ = AddProvidedInterface("Control");
  tendon::RequiredInterface& robot_ = AddRequiredInterface("Robot");
  double number_ = 0.0;
  tendon::VoidEvent stopped_;
  tendon::VoidFunction stop_;
};

TEST(LateAddition, IsRefusedAfterTheStart) {
  LocalManager manager;
  auto& arm = manager.Add<Late>("arm");
  ASSERT_TRUE(manager.StartAll().ok());
  ASSERT_TRUE(arm.Cycle());
  const std::string tail = " to component 'arm' (state active): add it in the constructor";
  const std::string sealed = " (sealed): add it in the constructor";

  EXPECT_EQ(Refusal([&] { arm.AddProvided(); }), "cannot add provided interface 'More'" + tail);
  EXPECT_EQ(Refusal([&] { arm.AddRequired(); }), "cannot add required interface 'More'" + tail);
  EXPECT_EQ(Refusal([&] { arm.AddTable(); }), "cannot add state table 'more'" + tail);
  EXPECT_EQ(Refusal([&] { arm.AddColumn(); }),
            "cannot add column 'Number' to state table 'state'" + sealed);
  EXPECT_EQ(Refusal([&] { arm.AddCommand(); }),
            "cannot add command 'Stop' to interface 'Control'" + sealed);
  EXPECT_EQ(Refusal([&] { arm.AddEvent(); }),
            "cannot add event 'Stopped' to interface 'Control'" + sealed);
  EXPECT_EQ(Refusal([&] { arm.AddFunction(); }),
            "cannot add function 'Stop' to interface 'Robot'" + sealed);
}

TEST(InvalidPeriod, IsRefusedWithItsRange) {
  LocalManager manager;
  const auto thrown = [&](std::chrono::nanoseconds period) {
    const std::string own = Refusal([&] { manager.Add<Periodic>("arm", period); });
    EXPECT_EQ(Refusal([&] { manager.Add<tendon_test::Main>("arm", period); }), own);
    return own;
  };
  const std::string sentence = "period of 'arm' must be 10 us..3600 s, got ";

  EXPECT_EQ(thrown(0ns), sentence + "0 ns");
  EXPECT_EQ(thrown(-1ms), sentence + "-1000000 ns");
  EXPECT_EQ(thrown(1ns), sentence + "1 ns");
  EXPECT_EQ(thrown(9999ns), sentence + "9999 ns");
  EXPECT_EQ(thrown(3600s + 1ns), sentence + "3600000000001 ns");
  EXPECT_EQ(thrown(std::chrono::nanoseconds::min()),
            sentence + std::to_string(std::numeric_limits<std::int64_t>::min()) + " ns");
  EXPECT_TRUE(manager.components().empty());
}

TEST(InvalidMailboxCapacity, IsRefusedWithItsRange) {
  tendon::RequiredInterface robot("Robot", nullptr);
  const std::string sentence = "mailbox capacity of 'Robot' must be 1..16777216, got ";

  EXPECT_EQ(Refusal([&] { robot.SetMailboxCapacity(0); }), sentence + "0");
  EXPECT_EQ(Refusal([&] { robot.SetMailboxCapacity((1U << 24U) + 1); }), sentence + "16777217");
  EXPECT_EQ(Refusal([&] { robot.SetMailboxCapacity(std::numeric_limits<std::size_t>::max()); }),
            sentence + "18446744073709551615");
  EXPECT_EQ(robot.mailbox_capacity(), 64U);
}

/// Connections with wrong interfaces.
struct Wiring : testing::Test {
  LocalManager manager;
  Callback& arm = manager.Add<Callback>("arm");
  Client& client = manager.Add<Client>("client");
  Client& other = manager.Add<Client>("other");

  std::string Refusal(const InterfaceName& required, const InterfaceName& provided) {
    return Refused(manager.Connect(required, provided));
  }
};

TEST_F(Wiring, NamesTheWrongEnd) {
  const std::string no_provided = " is a required interface; give a provided interface";

  EXPECT_EQ(Refusal({"client", "Server"}, {"client", "Server"}),
            "interface 'Server' of component 'client'" + no_provided);
  EXPECT_EQ(Refusal({"client", "Server"}, {"other", "Server"}),
            "interface 'Server' of component 'other'" + no_provided);
  EXPECT_EQ(
      Refusal({"arm", "Control"}, {"arm", "Control"}),
      "interface 'Control' of component 'arm' is a provided interface; give a required interface");
  EXPECT_TRUE(manager.connections().empty());
}

TEST_F(Wiring, SuggestsASimilarName) {
  EXPECT_EQ(Refusal({"client", "Server"}, {"arn", "Control"}),
            "no component 'arn'; did you mean 'arm'?");
  EXPECT_EQ(Refusal({"clinet", "Server"}, {"arm", "Control"}),
            "no component 'clinet'; did you mean 'client'?");
  EXPECT_EQ(Refusal({"client", "Sever"}, {"arm", "Control"}),
            "component 'client' has no required interface 'Sever'; did you mean 'Server'?");
  EXPECT_EQ(Refusal({"client", "Server"}, {"arm", "Contol"}),
            "component 'arm' has no provided interface 'Contol'; did you mean 'Control'?");
  EXPECT_EQ(Refusal({"client", "Server"}, {"warp-drive", "Control"}), "no component 'warp-drive'");
}

TEST_F(Wiring, RefusesToDisconnectAnUnconnectedEnd) {
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"arm", "Control"}).ok());
  ASSERT_TRUE(manager.Disconnect({"client", "Server"}).ok());

  EXPECT_EQ(Refused(manager.Disconnect({"client", "Server"})),
            "client/Server is not connected: there is nothing to disconnect");
  EXPECT_EQ(Refused(manager.Disconnect({"clinet", "Server"})),
            "no component 'clinet'; did you mean 'client'?");
}

TEST_F(Wiring, RefusesASecondConnectionOfOneEnd) {
  ASSERT_TRUE(manager.Connect({"client", "Server"}, {"arm", "Control"}).ok());

  EXPECT_EQ(Refusal({"client", "Server"}, {"arm", "Control"}),
            "client/Server is already connected; end that connection first");
  EXPECT_EQ(manager.connections().size(), 1U);
}

}  // namespace
