#include <gtest/gtest.h>

#include <bit>
#include <chrono>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/network_test.h"

namespace tendon {
namespace {

/// Stores numbers that clients send, and returns them.
class Keeper final : public Component {
 public:
  explicit Keeper(std::string name) : Component(std::move(name)) {
    auto& numbers = AddProvidedInterface("Numbers");
    numbers.AddCommandWrite(&Keeper::Keep, this, "Keep", kThreadSafe);
    numbers.AddCommandRead(&Keeper::Kept, this, "Kept", kThreadSafe);
  }

 private:
  void Keep(const std::vector<double>& numbers) { numbers_ = numbers; }
  void Kept(std::vector<double>& numbers) const { numbers = numbers_; }

  std::vector<double> numbers_;
};

class Owner final : public Component {
 public:
  explicit Owner(std::string name) : Component(std::move(name)) {
    auto& keeper = AddRequiredInterface("Keeper");
    keeper.AddFunction(keep, "Keep");
    keeper.AddFunction(kept, "Kept");
  }
  WriteFunction<std::vector<double>> keep;
  ReadFunction<std::vector<double>> kept;
};

class OddFloatingPointValues : public NetworkTest {};

TEST_P(OddFloatingPointValues, KeepTheirBits) {
  using Limits = std::numeric_limits<double>;
  const std::vector<double> odd{
      Limits::quiet_NaN(),     -Limits::quiet_NaN(),
      Limits::signaling_NaN(), Limits::infinity(),
      -Limits::infinity(),     Limits::denorm_min(),
      -Limits::denorm_min(),   -0.0,
      Limits::max(),           Limits::lowest(),
      Limits::min(),           std::bit_cast<double>(std::uint64_t{0x7ff8'dead'beef'1234})};
  const auto robot = Start("robot");
  robot->Add<Keeper>("keeper");
  const auto desk = Start("desk");
  auto& owner = desk->Add<Owner>("owner");
  ASSERT_TRUE(robot->StartAll().ok());
  ASSERT_TRUE(desk->StartAll().ok());
  ASSERT_TRUE(desk->Connect({"desk", "owner", "Keeper"}, {"robot", "keeper", "Numbers"}).ok());
  ASSERT_TRUE(EventuallyActive(*desk, 1));

  ASSERT_EQ(owner.keep.Wait(odd, std::chrono::seconds(20)), Status(Status::kDone));
  std::vector<double> kept;
  ASSERT_EQ(owner.kept(kept), Status(Status::kDone));

  ASSERT_EQ(kept.size(), odd.size());
  for (std::size_t i = 0; i < odd.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(kept[i]), std::bit_cast<std::uint64_t>(odd[i])) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Over, OddFloatingPointValues, testing::ValuesIn(NetworkKinds()),
                         NameOfNetwork);

}  // namespace
}  // namespace tendon
