#include <gtest/gtest.h>
#include <tendon/interface/connection.h>
#include <tendon/interface/execution/queued_command.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "support/allocation_guard.h"
#include "support/encoded.h"

namespace tendon_test {
namespace {

/// A number that records the address at which it is decoded. It fits into a mailbox slot.
struct TracedNumber {
  static inline const void* decoded_at = nullptr;
  static inline bool codec_throws = false;

  double number = 0.0;

  bool operator==(const TracedNumber&) const = default;
};

/// A list of names that counts its copies. It does not fit into a mailbox slot.
struct CountedNames {
  static inline int copies = 0;

  std::vector<std::string> names;

  CountedNames() = default;
  CountedNames(const CountedNames& other) : names(other.names) { ++copies; }
  CountedNames& operator=(const CountedNames& other) {
    names = other.names;
    ++copies;
    return *this;
  }
  ~CountedNames() = default;
};

}  // namespace
}  // namespace tendon_test

template <>
struct tendon::payload::SubstituteFor<tendon_test::TracedNumber> {
  using Type = double;

  static Type From(const tendon_test::TracedNumber& value) { return value.number; }
  static bool Into(double number, tendon_test::TracedNumber& value) {
    if (tendon_test::TracedNumber::codec_throws) throw std::runtime_error("broken");
    value.number = number;
    tendon_test::TracedNumber::decoded_at = &value;
    return true;
  }
};
template <>
inline constexpr auto tendon::kPayload<tendon_test::CountedNames> = tendon::Describe(
    "test.CountedNames", tendon::Field{"names", &tendon_test::CountedNames::names});

namespace tendon_test {
namespace {

using tendon::CallerThreads;
using tendon::Mailbox;
using tendon::None;
using tendon::Status;
using tendon::test::Encoded;
using Bytes = std::vector<std::byte>;

static_assert(tendon::kLiesInSlot<TracedNumber> && !tendon::kLiesInSlot<CountedNames>);

/// A mailbox for four encoded calls, from one thread or from any thread.
class EncodedCalls : public testing::TestWithParam<CallerThreads> {
 protected:
  template <typename In, typename Out = None, typename Handler>
  std::unique_ptr<tendon::CommandBase> Bind(Handler handler) {
    using Queued = tendon::QueuedCommand<In, Out, Handler>;
    mailbox_ = &inbox_.Open(4, Queued::Shape(), GetParam());
    inbox_.SetAccepting(true);
    return std::make_unique<Queued>(std::move(handler), mailbox_);
  }
  Status Call(tendon::CommandBase& command, const Bytes& in) {
    tendon::BytesSink sink(answer_);
    return command.ExecuteEncoded(in, sink);
  }

  tendon::Inbox inbox_;
  Mailbox* mailbox_ = nullptr;
  Bytes answer_;
};

TEST_P(EncodedCalls, DecodeANumberIntoItsSlot) {
  std::vector<const void*> handled_at;
  const auto command =
      Bind<TracedNumber>([&](const TracedNumber& in, None&) { handled_at.push_back(&in); });
  std::vector<const void*> decoded_at;

  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(Call(*command, Encoded(1.5)), Status::kQueued);
    decoded_at.push_back(TracedNumber::decoded_at);
  }
  inbox_.ExecuteQueued();

  EXPECT_EQ(handled_at, decoded_at);
  EXPECT_EQ(answer_, Encoded(None{}));
}

TEST_P(EncodedCalls, CopyNoDecodedArgument) {
  std::vector<std::string> heard;
  const auto command = Bind<CountedNames>([&](const CountedNames& in, None&) {
    heard.insert(heard.end(), in.names.begin(), in.names.end());
  });
  CountedNames::copies = 0;

  EXPECT_EQ(Call(*command, Encoded(std::vector<std::string>{"a", "b"})), Status::kQueued);
  EXPECT_EQ(Call(*command, Encoded(std::vector<std::string>{"c"})), Status::kQueued);
  inbox_.ExecuteQueued();

  EXPECT_EQ(heard, (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(CountedNames::copies, 0);
}

TEST_P(EncodedCalls, AllocateNothingOnceWarm) {
  const auto command = Bind<CountedNames>([](const CountedNames&, None&) {});
  const Bytes names = Encoded(std::vector<std::string>(3, std::string(100, 'x')));
  const auto call_four = [&] {
    for (int i = 0; i < 4; ++i) EXPECT_EQ(Call(*command, names), Status::kQueued);
    inbox_.ExecuteQueued();
  };
  call_four();

  const tendon::AllocationGuard guard;
  call_four();
}

TEST_P(EncodedCalls, SkipAMalformedArgument) {
  std::vector<double> heard;
  const auto command =
      Bind<TracedNumber>([&](const TracedNumber& in, None&) { heard.push_back(in.number); });
  EXPECT_EQ(Call(*command, Encoded(1.0)), Status::kQueued);

  EXPECT_EQ(Call(*command, Bytes(3)), Status::kInvalid);
  EXPECT_EQ(mailbox_->size(), 2U);
  EXPECT_EQ(Call(*command, Encoded(2.0)), Status::kQueued);
  inbox_.ExecuteQueued();

  EXPECT_EQ(heard, (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(mailbox_->size(), 0U);
}

TEST_P(EncodedCalls, SkipAnArgumentWithAThrowingCodec) {
  std::vector<double> heard;
  const auto command =
      Bind<TracedNumber>([&](const TracedNumber& in, None&) { heard.push_back(in.number); });

  TracedNumber::codec_throws = true;
  EXPECT_EQ(Call(*command, Encoded(1.0)), Status::kFailed);
  TracedNumber::codec_throws = false;
  EXPECT_EQ(Call(*command, Encoded(2.0)), Status::kQueued);
  inbox_.ExecuteQueued();

  EXPECT_EQ(heard, std::vector<double>{2.0});
}

TEST_P(EncodedCalls, AreRefusedByAFullMailboxBeforeTheyAreDecoded) {
  const auto command = Bind<TracedNumber>([](const TracedNumber&, None&) {});
  for (int i = 0; i < 4; ++i) EXPECT_EQ(Call(*command, Encoded(1.0)), Status::kQueued);
  TracedNumber::decoded_at = nullptr;

  EXPECT_EQ(Call(*command, Encoded(1.0)), Status::kQueueFull);
  EXPECT_EQ(Call(*command, Bytes(3)), Status::kQueueFull);

  EXPECT_EQ(TracedNumber::decoded_at, nullptr);
  EXPECT_EQ(mailbox_->refused(), 2U);
}

TEST_P(EncodedCalls, AreRefusedByAClosedMailbox) {
  const auto command = Bind<TracedNumber>([](const TracedNumber&, None&) {});
  mailbox_->Close();

  EXPECT_EQ(Call(*command, Encoded(1.0)), Status::kNotConnected);

  EXPECT_EQ(mailbox_->size(), 0U);
}

TEST_P(EncodedCalls, RenewNoExpiryIfTheArgumentIsMalformed) {
  tendon::Expiry expiry("Move", std::chrono::seconds(1), [] {});
  const auto handler = [](const TracedNumber&, None&) {};
  using Queued = tendon::QueuedCommand<TracedNumber, None, decltype(handler)>;
  mailbox_ = &inbox_.Open(4, Queued::Shape(), GetParam());
  inbox_.SetAccepting(true);
  Queued command(handler, mailbox_, nullptr, &expiry);

  EXPECT_EQ(Call(command, Bytes(3)), Status::kInvalid);
  inbox_.ExecuteQueued();
  EXPECT_EQ(expiry.due(), tendon::SteadyTime::max());

  EXPECT_EQ(Call(command, Encoded(1.0)), Status::kQueued);
  inbox_.ExecuteQueued();
  EXPECT_TRUE(expiry.IsOf(mailbox_->number()));
}

TEST_P(EncodedCalls, WithAReplyMustBeWaitedFor) {
  const auto command = Bind<TracedNumber, double>([](const TracedNumber&, double&) {});

  EXPECT_EQ(Call(*command, Encoded(1.0)), Status::kUnsupported);
  EXPECT_EQ(Call(*command, Bytes(3)), Status::kInvalid);

  EXPECT_EQ(mailbox_->size(), 0U);
}

TEST_P(EncodedCalls, WithoutAnArgumentTakeAnyBytes) {
  int calls = 0;
  const auto command = Bind<None>([&](const None&, None&) { ++calls; });

  EXPECT_EQ(Call(*command, {}), Status::kQueued);
  EXPECT_EQ(Call(*command, Encoded(None{})), Status::kQueued);
  inbox_.ExecuteQueued();

  EXPECT_EQ(calls, 2);
}

INSTANTIATE_TEST_SUITE_P(, EncodedCalls,
                         testing::Values(CallerThreads::kOneThread, CallerThreads::kManyThreads),
                         [](const auto& callers) {
                           return callers.param == CallerThreads::kOneThread ? "OneCaller"
                                                                             : "ManyCallers";
                         });

}  // namespace
}  // namespace tendon_test
