#include <gtest/gtest.h>
#include <support/simulation/report_matchers.h>
#include <support/simulation/simulated_atomics.h>
#include <tendon/lockfree/completion.h>
#include <tendon/lockfree/flag.h>
#include <tendon/proxy/outstanding_calls.h>
#include <tendon/proxy/read_offer_proxy.h>

#include <array>
#include <cstddef>
#include <memory>

namespace tendon::simulation {
namespace {

class Mutex {
 public:
  void lock() {
    for (std::uint32_t free = 0; !held_.compare_exchange_strong(free, 1); free = 0) {
      while (held_.load() != 0) SimulatedAtomics::Pause(0);
    }
  }
  void unlock() { held_.store(0); }

 private:
  SimulatedAtomics::Atomic<std::uint32_t> held_{0};
};

/// One record that all calls use one after the other.
struct Records {
  Completion<SimulatedAtomics> record;

  Completion<SimulatedAtomics>& operator[](std::size_t /*record*/) { return record; }
  [[nodiscard]] static std::size_t size() { return 1; }
};

/// The state of the link and the peer when the network thread sends a call.
enum class Peer { kAnswers, kIsSilent, kIsGone, kHasNoRoom };

/// Two calls of one thread. The caller may give up the first call at any moment. The second call
/// uses the same record, and the caller waits for it.
class Link {
 public:
  explicit Link(Peer first) : first_(first) {}

  void Wait() {
    const bool is_sent = WaitFor(0, true);
    may_be_executed_ = is_sent;
    WaitFor(1, false);
  }

  void Serve() {
    Serve(0, first_);
    is_first_over_.Set(true);
    Serve(1, Peer::kAnswers);
  }

  void Finally() {
    Check(may_be_executed_ || !is_sent_[0], "sent, though its caller was told that it will not be");
    Check(is_sent_[1], "the second call was lost");
    Check(records_.record.TryTake(), "the record was not freed");
  }

 private:
  using Ending = Completion<SimulatedAtomics>::Ending;

  /// Returns true if the caller must assume that the call may be executed.
  bool WaitFor(std::size_t slot, bool is_hasty) {
    if (!records_.record.TryTake()) {
      for (unsigned looks = 0; !is_first_over_.Get(); ++looks) SimulatedAtomics::Pause(looks);
      Check(records_.record.TryTake(), "the record was not freed");
    }
    const std::uint64_t call = callers_.Enter(0, SteadyTime::max());
    posted_[slot].Set(true);
    const Ending ending = records_.record.Await([&] { return is_hasty; }, SteadyTime::max());
    const bool is_sent = callers_.Leave(call, ending);
    if (ending != Ending::kDone) return ending == Ending::kStarted && is_sent;
    const Status status = records_.record.status();
    if (status) Check(callers_.reply(0) == Answer(slot), "another call's answer");
    Check(is_hasty || status, "another call's end");
    records_.record.Free();
    return status != Status(Status::kNotConnected);
  }

  void Serve(std::size_t slot, Peer peer) {
    for (unsigned looks = 0; !posted_[slot].Get(); ++looks) SimulatedAtomics::Pause(looks);
    if (peer == Peer::kIsGone) return callers_.Drop(0);
    const auto call = callers_.Start(0);
    if (!call || !callers_.Send(*call, SteadyTime::min())) return;
    if (peer == Peer::kHasNoRoom) {
      callers_.NotSent(*call);
      if (!callers_.Send(*call, SteadyTime::min())) return;
    }
    is_sent_[slot] = true;
    if (peer == Peer::kIsSilent) return callers_.End(*call, Error{ErrorCode::kTimeout, "late"});
    Bytes result = Answer(slot);
    AppendStatus(Status::kDone, result);
    callers_.End(*call, std::move(result));
  }

  static Bytes Answer(std::size_t slot) { return Bytes(slot + 1); }

  const Peer first_;
  Records records_;
  OutstandingCalls<Records, Mutex> callers_{records_};
  std::array<Published<bool, SimulatedAtomics>, 2> posted_;
  Published<bool, SimulatedAtomics> is_first_over_{false};
  std::array<bool, 2> is_sent_{};
  bool may_be_executed_ = false;
};

class OutstandingCallsSimulation : public testing::TestWithParam<Peer> {};

TEST_P(OutstandingCallsSimulation, EndsEachCallOnceAndSendsNoCancelledOne) {
  const Report report = Explore(
      [](Scenario& scenario) {
        const auto link = std::make_shared<Link>(GetParam());
        scenario.Thread([=] { link->Wait(); });
        scenario.Thread([=] { link->Serve(); });
        scenario.Finally([=] { link->Finally(); });
      },
      {.preemptions = 3, .stale_reads = 0});

  EXPECT_THAT(report, Passes(100));
}

INSTANTIATE_TEST_SUITE_P(With, OutstandingCallsSimulation,
                         testing::Values(Peer::kAnswers, Peer::kIsSilent, Peer::kIsGone,
                                         Peer::kHasNoRoom));

}  // namespace
}  // namespace tendon::simulation
