#include <gtest/gtest.h>
#include <tendon/base/os/process.h>
#include <tendon/gcm/diagnosis.h>
#include <tendon/gcm/lookup.h>
#include <tests/core/gcm/samples.h>

namespace tendon {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using Kind = CatalogueChange::Kind;
using Verdict = DiagnosisStep::Verdict;

const message::ConnectionEnds kEnds{{"desk", "teleoperation", "Robot"},
                                    {"robot", "arm", "Control"}};

class DiagnosisTest : public testing::Test {
 protected:
  DiagnosisTest() {
    Enter(robot_, {test::Arm(), test::FakeArm()});
    Enter(desk_, {test::Teleoperation()});
  }

  void Apply(CatalogueChange change) {
    change.revision = catalogue_.revision() + 1;
    EXPECT_TRUE(catalogue_.Apply(change));
  }
  void Enter(const ProcessDescription& process,
             const std::vector<ComponentDescription>& components = {}) {
    Apply({.kind = Kind::kProcess, .process = process.name, .processes = {process}});
    for (const auto& component : components) {
      Apply({.kind = Kind::kComponent, .process = process.name, .components = {component}});
    }
  }
  void Connect(ConnectionState state, const std::string& reason = {},
               const InterfaceName& provided = kEnds.provided) {
    Apply({.kind = Kind::kConnection,
           .process = "desk",
           .connections = {{.id = 1,
                            .required = kEnds.required,
                            .provided = provided,
                            .state = state,
                            .reason = reason}}});
  }

  Diagnosis Examine(const message::ConnectionEnds& ends = kEnds) {
    const auto diagnosis = Diagnose(catalogue_, ends);
    EXPECT_TRUE(diagnosis) << diagnosis.error().message;
    if (!diagnosis) return {};
    EXPECT_EQ(diagnosis->steps.size(), 7U);
    return *diagnosis;
  }
  /// Expects that step `number` has failed, that all earlier steps are good, and that the later
  /// steps were not checked.
  static void ExpectBad(const Diagnosis& diagnosis, std::size_t number, ErrorCode code,
                        const std::string& text) {
    ASSERT_EQ(diagnosis.steps.size(), 7U);
    for (std::size_t i = 0; i < 7; ++i) {
      const Verdict expected = i + 1 < number    ? Verdict::kGood
                               : i + 1 == number ? Verdict::kBad
                                                 : Verdict::kNotReached;
      EXPECT_EQ(diagnosis.steps[i].verdict, expected) << i + 1 << diagnosis.steps[i].text;
      EXPECT_FALSE(diagnosis.steps[i].text.empty());
    }
    EXPECT_EQ(diagnosis.steps[number - 1].text, text);
    EXPECT_FALSE(diagnosis.steps[number - 1].fix.empty());
    ASSERT_TRUE(diagnosis.failure);
    EXPECT_EQ(diagnosis.failure->code, code);
  }

  /// Returns the host of the check.
  static std::string FromHere() { return " (seen from host " + os::HostName() + ")"; }
  [[nodiscard]] std::string FromDesk() const { return " (seen from host " + desk_.host + ")"; }

  Catalogue catalogue_;
  ProcessDescription robot_ = test::ProcessNamed("robot", 1);
  ProcessDescription desk_ = test::ProcessNamed("desk", 2);
};

TEST_F(DiagnosisTest, OfAnActiveConnectionHasNoFailure) {
  Connect(ConnectionState::kActive);

  Diagnosis diagnosis = Examine();
  AddRoundTrip(diagnosis, 800us);

  EXPECT_TRUE(diagnosis.is_connected);
  EXPECT_FALSE(diagnosis.failure);
  for (const auto& step : diagnosis.steps) EXPECT_EQ(step.verdict, Verdict::kGood) << step.text;
  EXPECT_EQ(diagnosis.steps[3].text, "signatures match: 2 of 2");
  EXPECT_EQ(diagnosis.steps[6].text, "process 'robot' answers within 800 us" + FromHere());
}

TEST_F(DiagnosisTest, OfAnUnconnectedPairOmitsUntriedSteps) {
  const Diagnosis diagnosis = Examine();

  EXPECT_FALSE(diagnosis.is_connected);
  EXPECT_FALSE(diagnosis.failure);
  EXPECT_EQ(diagnosis.steps[3].verdict, Verdict::kGood);
  EXPECT_EQ(diagnosis.steps[4].verdict, Verdict::kNotReached);
}

TEST_F(DiagnosisTest, FindsALostProcess) {
  robot_.state = ProcessState::kLost;
  robot_.reason = "its connection broke";
  Enter(robot_);

  ExpectBad(Examine(), 1, ErrorCode::kUnreachable,
            "process 'robot' is lost (its connection broke)");
}

TEST_F(DiagnosisTest, FindsAFault) {
  ComponentDescription arm = test::Arm();
  arm.state = ComponentState::kFaulted;
  arm.fault = "out of range";
  Apply({.kind = Kind::kComponent, .process = "robot", .components = {arm}});

  ExpectBad(Examine(), 2, ErrorCode::kFailed, "component 'arm' is faulted: out of range");
}

TEST_F(DiagnosisTest, FindsAStoppedComponentOfAnActiveConnection) {
  ComponentDescription arm = test::Arm();
  arm.state = ComponentState::kSuspended;
  Apply({.kind = Kind::kComponent, .process = "robot", .components = {arm}});
  const auto examine = [this] {
    Diagnosis diagnosis = Examine();
    AddRoundTrip(diagnosis, 800us);
    AddActivity(diagnosis, catalogue_);
    return diagnosis;
  };
  EXPECT_FALSE(examine().failure);  // the connection can be made
  Connect(ConnectionState::kActive);

  const Diagnosis of_provider = examine();
  EXPECT_EQ(of_provider.steps[1].verdict, Verdict::kBad);
  EXPECT_EQ(of_provider.steps[1].text,
            "arm is suspended: it refuses commands, and its reads return old values");
  EXPECT_EQ(of_provider.steps[1].fix, "gcm start robot/arm");
  for (const int behind : {2, 3, 4, 5, 6}) {
    EXPECT_EQ(of_provider.steps[static_cast<std::size_t>(behind)].verdict, Verdict::kGood);
  }
  ASSERT_TRUE(of_provider.failure);
  EXPECT_EQ(of_provider.failure->code, ErrorCode::kFailed);

  ComponentDescription teleoperation = test::Teleoperation();
  teleoperation.state = ComponentState::kReady;
  Enter(desk_, {teleoperation});
  Connect(ConnectionState::kActive);
  EXPECT_EQ(examine().steps[1].text, "teleoperation is ready: it makes no calls");
  EXPECT_EQ(examine().steps[1].fix, "gcm start desk/teleoperation");
}

TEST_F(DiagnosisTest, FindsAConnectionToAnotherProvider) {
  Connect(ConnectionState::kActive, {}, {"robot", "second", "Control"});

  ExpectBad(Examine(), 3, ErrorCode::kExists,
            "desk/teleoperation/Robot is connected to robot/second/Control");
  EXPECT_EQ(Examine().steps[2].fix,
            "to replace this connection: gcm connect desk/teleoperation/Robot robot/arm/Control "
            "--replace");
}

TEST_F(DiagnosisTest, FindsMismatchedSignatures) {
  const Diagnosis diagnosis = Examine({kEnds.required, {"robot", "fake", "Control"}});

  ExpectBad(diagnosis, 4, ErrorCode::kIncompatible, "signatures match: 1 of 2");
  EXPECT_EQ(diagnosis.steps[3].details.size(), 1U);
  EXPECT_EQ(diagnosis.steps[3].fix,
            "to list the compatible interfaces: gcm candidates desk/teleoperation/Robot");
}

TEST_F(DiagnosisTest, FindsALoopbackAddressOfAnotherHost) {
  robot_.host = "far";
  Enter(robot_);

  const Diagnosis diagnosis = Examine();

  ExpectBad(diagnosis, 5, ErrorCode::kUnreachable,
            "desk on host bench cannot reach robot at " + robot_.address);
  EXPECT_EQ(diagnosis.steps[4].fix,
            "start robot with --listen and --advertise and an address of host far");
}

TEST_F(DiagnosisTest, FindsAPendingConnection) {
  Connect(ConnectionState::kPending, "robot did not answer");

  ExpectBad(Examine(), 5, ErrorCode::kTimeout,
            "the connection is pending: robot did not answer" + FromDesk());
}

TEST_F(DiagnosisTest, AnUnreachableProcessFailsTheFifthStep) {
  const Error refused{ErrorCode::kFailed,
                      "process 'robot' does not answer at 127.0.1.1:9: refused"};
  Diagnosis before = Examine();
  AddRoundTrip(before, refused);
  ExpectBad(before, 5, ErrorCode::kFailed, refused.message + FromHere());
  EXPECT_NE(before.steps[4].fix.find("start robot with --advertise"), std::string::npos);

  Connect(ConnectionState::kPending, "robot cannot be reached");
  Diagnosis after = Examine();
  ASSERT_TRUE(IsTrying(after));
  AddRoundTrip(after, refused);
  ExpectBad(after, 5, ErrorCode::kFailed,
            "the connection is pending: robot cannot be reached" + FromDesk());
  EXPECT_EQ(after.steps[4].fix, before.steps[4].fix);
}

TEST_F(DiagnosisTest, AProcessReachableFromHereMayNotAnswerItsPeer) {
  Connect(ConnectionState::kPending, "robot did not answer");
  Diagnosis diagnosis = Examine();
  AddRoundTrip(diagnosis, 800us);
  ExpectBad(diagnosis, 5, ErrorCode::kTimeout,
            "the connection is pending: robot did not answer" + FromDesk());

  AddRoundTrip(diagnosis, Error{ErrorCode::kTimeout, "no reply"});
  ExpectBad(diagnosis, 5, ErrorCode::kTimeout,
            "the connection is pending: robot did not answer" + FromDesk());
  EXPECT_EQ(diagnosis.steps[4].fix, "check process 'robot': it may hang");
}

TEST_F(DiagnosisTest, AMissingRouteIsBlamedOnItsTarget) {
  const std::string no_route =
      "host '" + desk_.host + "' has no route to 10.9.1.2:9 (Network is unreachable)";
  Connect(ConnectionState::kPending, no_route);
  Diagnosis diagnosis = Examine();
  ExpectBad(diagnosis, 5, ErrorCode::kTimeout,
            "the connection is pending: " + no_route + FromDesk());
  EXPECT_EQ(diagnosis.steps[4].fix.find("give host " + desk_.host + " a route to this address"),
            0U);

  const DiagnosisStep before = diagnosis.steps[4];
  AddRoundTrip(diagnosis, Error{ErrorCode::kTimeout, "no reply"});
  EXPECT_EQ(diagnosis.steps[4], before) << "what we see from here does not change that";
}

TEST_F(DiagnosisTest, SuggestsAnotherListenAddressIfOnlyLocal) {
  robot_.reason =
      "can be reached at 127.0.0.1:9 only from its own host; start this process with --listen X";
  Enter(robot_);
  Connect(ConnectionState::kPending, "robot cannot be reached");

  EXPECT_EQ(Examine().steps[4].fix, "robot " + robot_.reason);
}

TEST_F(DiagnosisTest, SuggestsResumingOrEndingASilentProcess) {
  robot_.state = ProcessState::kLost;
  robot_.reason = std::string(kNoRenewal) + "1501 ms";
  robot_.pid = 4711;
  Enter(robot_);

  const Diagnosis diagnosis = Examine();

  ExpectBad(diagnosis, 1, ErrorCode::kUnreachable,
            "process 'robot' is lost (no renewal of its lease for 1501 ms)");
  EXPECT_NE(diagnosis.steps[0].fix.find("kill -CONT 4711"), std::string::npos);
}

TEST_F(DiagnosisTest, FindsARefusedConnection) {
  Connect(ConnectionState::kFailed, "no");

  ExpectBad(Examine(), 6, ErrorCode::kFailed, "the connection was refused: no");
}

TEST_F(DiagnosisTest, FindsAnUnresponsiveProcess) {
  Connect(ConnectionState::kActive);
  Diagnosis diagnosis = Examine();

  AddRoundTrip(diagnosis, Error{ErrorCode::kTimeout, "no reply"});

  ExpectBad(diagnosis, 7, ErrorCode::kTimeout, "no reply" + FromHere());
}

TEST_F(DiagnosisTest, FindsLossesOfAnActiveConnection) {
  Connect(ConnectionState::kActive);
  Diagnosis diagnosis = Examine();
  const ConnectionCounts before{.capacity = 10, .refused = 3};

  AddHealth(diagnosis, FlawsOf(before, before));
  EXPECT_FALSE(diagnosis.failure);
  AddHealth(diagnosis, FlawsOf({.capacity = 10, .waiting = 8, .refused = 4}, before));
  AddRoundTrip(diagnosis, 800us);

  ExpectBad(diagnosis, 6, ErrorCode::kFailed,
            "the connection is made, but 4 calls were refused, because the mailbox was full; 8 of "
            "10 calls wait");
  EXPECT_EQ(diagnosis.steps[5].fix, "to find the component that is too slow: gcm top");
}

TEST_F(DiagnosisTest, FindsASlowActiveConnection) {
  Connect(ConnectionState::kActive);
  Diagnosis diagnosis = Examine();

  AddHealth(diagnosis, FlawsOf({.round_trip = 100ms}, std::nullopt));
  EXPECT_FALSE(diagnosis.failure);
  AddHealth(diagnosis, FlawsOf({.round_trip = 250ms}, std::nullopt));
  AddRoundTrip(diagnosis, 800us);

  ExpectBad(diagnosis, 7, ErrorCode::kFailed, "process 'robot' answers after 250 ms");
}

TEST_F(DiagnosisTest, OfAMissingInterfaceIsAnError) {
  EXPECT_EQ(Diagnose(catalogue_, {kEnds.required, {"robot", "arn", "Control"}}).error().code,
            ErrorCode::kNotFound);
  EXPECT_EQ(Diagnose(catalogue_, {kEnds.provided, kEnds.provided}).error().code,
            ErrorCode::kNotFound);
}

TEST_F(DiagnosisTest, NamesTheUnknownProviderOfAPendingConnection) {
  const message::ConnectionEnds to_process{kEnds.required, {"robbot", "arm", "Control"}};
  const message::ConnectionEnds to_component{kEnds.required, {"robot", "arn", "Control"}};
  Connect(ConnectionState::kPending, "is not available", to_process.provided);
  ExpectBad(Examine(to_process), 1, ErrorCode::kNotFound,
            "no process 'robbot'; did you mean 'robot'?");

  Connect(ConnectionState::kPending, "is not available", to_component.provided);

  const Diagnosis diagnosis = Examine(to_component);
  ExpectBad(diagnosis, 2, ErrorCode::kNotFound, "no component 'robot/arn'; did you mean 'arm'?");
  EXPECT_TRUE(diagnosis.is_connected);
}

TEST_F(DiagnosisTest, ARefusedConnectionLeavesNoRemnants) {
  Diagnosis diagnosis = Examine({kEnds.required, {"robot", "fake", "Control"}});
  using Left = ConnectionRemnant::Verdict;
  const Error none{ErrorCode::kNotFound, "serves nothing"};

  AddRemnants(diagnosis, catalogue_, none);

  EXPECT_EQ(diagnosis.remnants,
            (std::vector<ConnectionRemnant>{{"desk", Left::kNothing, "nothing in desk"},
                                            {"robot", Left::kNothing, "nothing in robot"}}));
  EXPECT_EQ(LeftoverTexts(diagnosis), (std::vector<std::string>{"left over: nothing in desk",
                                                                "left over: nothing in robot"}));

  AddRemnants(diagnosis, catalogue_, ConnectionCounts{});
  EXPECT_EQ(diagnosis.remnants[1].verdict, Left::kSomething);
  AddRemnants(diagnosis, catalogue_, Error{ErrorCode::kTimeout, "no reply"});
  EXPECT_EQ(diagnosis.remnants[1].verdict, Left::kUnknown);
  EXPECT_EQ(diagnosis.remnants[1].text,
            "unknown, because process 'robot' does not report whether it still serves the "
            "connection: no reply");

  Connect(ConnectionState::kActive);  // to another interface in the same process
  AddRemnants(diagnosis, catalogue_, ConnectionCounts{});
  EXPECT_EQ(diagnosis.remnants[0].text,
            "nothing in desk, where teleoperation/Robot is connected to "
            "robot/arm/Control");
  EXPECT_EQ(diagnosis.remnants[1].verdict, Left::kNothing);
}

TEST_F(DiagnosisTest, AWantedConnectionHasNoRemnants) {
  Connect(ConnectionState::kPending, "robot did not answer");
  Diagnosis diagnosis = Examine();

  AddRemnants(diagnosis, catalogue_, ConnectionCounts{});

  EXPECT_TRUE(diagnosis.remnants.empty());
  EXPECT_EQ(LeftoverTexts(diagnosis),
            std::vector<std::string>{"requested: desk makes the connection as soon as possible"});
  Connect(ConnectionState::kActive);
  EXPECT_TRUE(LeftoverTexts(Examine()).empty());

  robot_.state = ProcessState::kLost;
  Enter(robot_);
  Diagnosis lost = Examine();
  AddRemnants(lost, catalogue_, Error{ErrorCode::kUnreachable, "lost"});
  EXPECT_EQ(LeftoverTexts(lost),
            std::vector<std::string>{"requested: desk makes the connection as soon as possible"});
}

TEST_F(DiagnosisTest, RemnantsAreUnknownIfTheClientProcessIsLost) {
  Connect(ConnectionState::kActive);
  EXPECT_FALSE(IsKept(Examine()));
  desk_.state = ProcessState::kLost;
  Apply({.kind = Kind::kProcess, .process = "desk", .processes = {desk_}});
  Diagnosis diagnosis = Examine();

  AddRemnants(diagnosis, catalogue_, Error{ErrorCode::kNotFound, "serves nothing"});

  EXPECT_FALSE(IsKept(diagnosis));
  EXPECT_EQ(LeftoverTexts(diagnosis),
            (std::vector<std::string>{"left over: unknown, because process 'desk' is not available",
                                      "left over: nothing in robot"}));
  robot_.state = ProcessState::kLost;
  Enter(robot_);
  EXPECT_FALSE(IsKept(Examine()));
}

TEST_F(DiagnosisTest, CandidatesAreRankedByHowMuchFits) {
  Enter(desk_, {test::Arm("b_arm"), test::Arm("a_arm")});
  Connect(ConnectionState::kActive);

  const auto candidates = RankCandidates(catalogue_, kEnds.required);

  ASSERT_TRUE(candidates);
  std::vector<std::string> names;
  for (const auto& candidate : *candidates) names.push_back(ToString(candidate.provided));
  EXPECT_EQ(names, (std::vector<std::string>{"desk/a_arm/Control", "desk/b_arm/Control",
                                             "robot/arm/Control", "robot/fake/Control"}));
  EXPECT_TRUE((*candidates)[2].is_connected);
  EXPECT_TRUE((*candidates)[2].compatibility.fits());
  EXPECT_FALSE((*candidates)[3].compatibility.fits());
}

TEST_F(DiagnosisTest, AnAbsentProcessHasNoCandidates) {
  robot_.state = ProcessState::kLeft;
  Enter(robot_);

  EXPECT_TRUE(RankCandidates(catalogue_, kEnds.required)->empty());
}

}  // namespace
}  // namespace tendon
