#include <gtest/gtest.h>
#include <tendon/interface/execution/converting_command.h>

#include <algorithm>
#include <new>
#include <string>
#include <vector>

#include "support/allocation_guard.h"
#include "support/encoded.h"

namespace tendon_test {
namespace {

using tendon::ArgumentWriter;
using tendon::CommandBase;
using tendon::None;
using tendon::ReplySink;
using tendon::Status;
using tendon::test::Encoded;
using Bytes = std::vector<std::byte>;

/// Requests the argument in the memory `kept`.
class KeepingTarget final : public CommandBase {
 public:
  KeepingTarget() : CommandBase(tendon::layout::kNone, tendon::layout::kNone) {}

  Status ExecuteEncoded(std::span<const std::byte> /*in*/, ReplySink& /*out*/) override {
    ADD_FAILURE() << "the argument was encoded elsewhere";
    return Status::kFailed;
  }
  Status ExecuteFrom(const ArgumentWriter& in, ReplySink& /*out*/) override {
    if (!accepts) return Status::kQueueFull;
    kept.resize(in.size());
    return in.WriteTo(kept) ? Status::kQueued : Status::kFailed;
  }

  bool accepts = true;
  Bytes kept;
};

/// Requests encoded bytes, and returns them.
class EchoingTarget final : public CommandBase {
 public:
  EchoingTarget() : CommandBase(tendon::layout::kNone, tendon::layout::kNone) {}

  Status ExecuteEncoded(std::span<const std::byte> in, ReplySink& out) override {
    std::ranges::copy(in, out.Room(in.size()).begin());
    return Status::kDone;
  }
};

/// A number whose codec counts its writes.
struct WrittenNumber {
  static inline int writes = 0;

  double number = 0.0;

  bool operator==(const WrittenNumber&) const = default;
};

}  // namespace
}  // namespace tendon_test

template <>
struct tendon::payload::SubstituteFor<tendon_test::WrittenNumber> {
  using Type = double;

  static Type From(const tendon_test::WrittenNumber& value) {
    ++tendon_test::WrittenNumber::writes;
    return value.number;
  }
  static bool Into(double number, tendon_test::WrittenNumber& value) {
    value.number = number;
    return true;
  }
};

namespace tendon_test {
namespace {

TEST(ConvertingCommand, EncodesTheArgumentOnceIntoTheTarget) {
  KeepingTarget target;
  tendon::ConvertingCommand<WrittenNumber, None> command(target);
  WrittenNumber::writes = 0;
  None nothing;

  EXPECT_EQ(command.Execute(WrittenNumber{2.5}, nothing), Status::kQueued);

  EXPECT_EQ(WrittenNumber::writes, 1);
  EXPECT_EQ(target.kept, Encoded(2.5));
}

TEST(ConvertingCommand, EncodesNothingIfTheTargetRefuses) {
  KeepingTarget target;
  target.accepts = false;
  tendon::ConvertingCommand<WrittenNumber, None> command(target);
  WrittenNumber::writes = 0;
  None nothing;

  EXPECT_EQ(command.Execute(WrittenNumber{2.5}, nothing), Status::kQueueFull);

  EXPECT_EQ(WrittenNumber::writes, 0);
}

TEST(ConvertingCommand, AllocatesOnlyInTheTarget) {
  KeepingTarget target;
  target.kept.reserve(1000);
  tendon::ConvertingCommand<std::string, None> command(target);
  const std::string text(100, 'x');
  None nothing;

  const tendon::AllocationGuard guard;  // the first call must not allocate either
  EXPECT_EQ(command.Execute(text, nothing), Status::kQueued);
}

TEST(ConvertingCommand, PassesBytesToATargetThatTakesBytes) {
  EchoingTarget target;
  tendon::ConvertingCommand<std::string, std::string> command(target);
  std::string result;

  EXPECT_EQ(command.Execute("to and fro", result), Status::kDone);

  EXPECT_EQ(result, "to and fro");
}

}  // namespace
}  // namespace tendon_test
