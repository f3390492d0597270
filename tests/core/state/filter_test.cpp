#include <core/state/sample.h>
#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <tendon/state/state_table.h>

#include <string>

namespace tendon {
namespace {

using test::TimeOf;

/// A first-order low-pass filter.
class Smooth {
 public:
  explicit Smooth(double weight) : weight_(weight) {}

  void operator()(const double& input, double& output) noexcept {
    value_ += weight_ * (input - value_);
    output = value_;
  }

 private:
  double weight_;
  double value_ = 0;
};

class FilterTest : public testing::Test {
 protected:
  double Newest(const double& column) const {
    double value = -1;
    EXPECT_EQ(table_.Find(column).ReadNewest(value), Status::kDone);
    return value;
  }

  StateTable table_;
  double raw_ = 0;
  double smooth_ = 0;
  double square_ = 0;
};

TEST_F(FilterTest, ComputesAColumnOncePerRow) {
  table_.Add(raw_, "Raw");
  table_.AddFiltered(raw_, smooth_, Smooth(0.5), "Smooth");

  raw_ = 8;
  table_.Advance(TimeOf(0));
  EXPECT_EQ(Newest(smooth_), 4.0);
  table_.Advance(TimeOf(1));
  EXPECT_EQ(Newest(smooth_), 6.0);

  EXPECT_EQ(Newest(raw_), 8.0);
  EXPECT_NE(table_.Find("Smooth"), nullptr);
}

TEST_F(FilterTest, AFilterMayUseTheOutputOfAnother) {
  table_.AddFiltered(raw_, smooth_, Smooth(0.5), "Smooth");
  table_.AddFiltered(
      smooth_, square_,
      [](const double& input, double& output) noexcept { output = input * input; }, "Square");
  raw_ = 6;
  table_.Advance(TimeOf(0));
  EXPECT_EQ(Newest(square_), 9.0);
}

TEST_F(FilterTest, DoesNotRunInACycleWithoutARow) {
  table_.AddFiltered(raw_, smooth_, Smooth(0.5), "Smooth");
  table_.AdvanceOnlyByHand();
  raw_ = 8;
  for (std::uint64_t cycle = 0; cycle < 10; ++cycle) table_.AdvanceAfterCycle(TimeOf(cycle));
  table_.Advance(TimeOf(10));
  EXPECT_EQ(Newest(smooth_), 4.0);
}

TEST_F(FilterTest, OfARefusedColumnDoesNotRun) {
  table_.AddFiltered(raw_, smooth_, Smooth(0.5), "Smooth");
  EXPECT_THROW(table_.AddFiltered(raw_, square_, Smooth(0.5), "Smooth"), ConfigurationError);
  raw_ = 2;
  table_.Advance(TimeOf(0));
  EXPECT_EQ(square_, 0.0);
}

TEST_F(FilterTest, MayComputeADynamicColumnWithoutAllocation) {
  std::string stars;
  table_.AddFiltered(
      raw_, stars,
      [](const double& input, std::string& output) noexcept {
        output.assign(static_cast<std::size_t>(input), '*');
      },
      "Stars", 64);
  raw_ = 40;
  table_.Advance(TimeOf(0));
  raw_ = 30;
  {
    const AllocationGuard guard;
    table_.Advance(TimeOf(1));
  }
  std::string value;
  EXPECT_EQ(table_.Find(stars).ReadNewest(value), Status::kDone);
  EXPECT_EQ(value, std::string(30, '*'));
}

}  // namespace
}  // namespace tendon
