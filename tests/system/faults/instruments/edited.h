#pragma once

#include <tendon/interface/function.h>
#include <tendon/payload/payload.h>
#include <tendon/task/component.h>
#include <tendon/task/periodic_task.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

namespace faults {

/// The place at which a force is measured.
enum class Frame : std::uint8_t { kBase, kTool };
enum class FrameWithOneMore : std::uint8_t { kBase, kTool, kCamera };

/// The type of the sensor, and the edited copies of this type in other programs. The name of each
/// copy says how it differs.
template <typename Number, typename Torque, typename FrameType, int kEdit>
struct ForceOf {
  Number fx{};
  double fy = 0;
  Torque torque{};
  FrameType frame{};
  double more = 0;
};
using Torque3 = std::array<double, 3>;
using Torque2 = std::array<double, 2>;
using Force = ForceOf<double, Torque3, Frame, 0>;
using ForceInFloats = ForceOf<float, Torque3, Frame, 0>;
using ForceInPounds = ForceOf<double, Torque3, Frame, 1>;
using ForceRenamed = ForceOf<double, Torque3, Frame, 2>;
using ForceWithMore = ForceOf<double, Torque3, Frame, 3>;
using ForceWithLess = ForceOf<double, Torque3, Frame, 4>;
using ForceInOtherOrder = ForceOf<double, Torque3, Frame, 5>;
using ForceOfOtherShape = ForceOf<double, Torque2, Frame, 0>;
using ForceInOtherFrames = ForceOf<double, Torque3, FrameWithOneMore, 0>;

/// Receives forces of the original type.
class Sensor final : public tendon::PeriodicTask {
 public:
  explicit Sensor(std::string name) : PeriodicTask(std::move(name), std::chrono::milliseconds(5)) {
    AddProvidedInterface("Force").AddCommandWrite(&Sensor::Push, this, "Push");
  }

 private:
  void Run() override { ProcessQueuedCommands(); }
  void Push(const Force& /*force*/) {}
};

/// A client whose function sends forces of type T.
template <typename T>
class Pusher final : public tendon::PeriodicTask {
 public:
  explicit Pusher(std::string name) : PeriodicTask(std::move(name), std::chrono::milliseconds(5)) {
    AddRequiredInterface("Force").AddFunction(push_, "Push");
  }

 private:
  void Run() override { ProcessQueuedCommands(); }

  tendon::WriteFunction<T> push_;
};

}  // namespace faults

template <>
inline constexpr auto tendon::kPayload<faults::Frame> =
    tendon::DescribeEnum("faults.Frame", tendon::Enumerator{"base", faults::Frame::kBase},
                         tendon::Enumerator{"tool", faults::Frame::kTool});
template <>
inline constexpr auto tendon::kPayload<faults::FrameWithOneMore> = tendon::DescribeEnum(
    "faults.Frame", tendon::Enumerator{"base", faults::FrameWithOneMore::kBase},
    tendon::Enumerator{"tool", faults::FrameWithOneMore::kTool},
    tendon::Enumerator{"camera", faults::FrameWithOneMore::kCamera});

namespace faults {

template <typename T>
inline constexpr auto kFy = tendon::Field{"fy", &T::fy, "N"};
template <typename T>
inline constexpr auto kTorque = tendon::Field{"torque", &T::torque, "Nm"};
template <typename T>
inline constexpr auto kFrame = tendon::Field{"frame", &T::frame};

/// Describes the type as usual, but with this name and unit of the first field.
template <typename T>
consteval auto DescribeForce(const char* fx = "fx", const char* unit = "N") {
  return tendon::Describe("faults.Force", tendon::Field{fx, &T::fx, unit}, kFy<T>, kTorque<T>,
                          kFrame<T>);
}

}  // namespace faults

template <typename Number, typename Torque, typename FrameType>
inline constexpr auto tendon::kPayload<faults::ForceOf<Number, Torque, FrameType, 0>> =
    faults::DescribeForce<faults::ForceOf<Number, Torque, FrameType, 0>>();
template <>
inline constexpr auto tendon::kPayload<faults::ForceInPounds> =
    faults::DescribeForce<faults::ForceInPounds>("fx", "lbf");
template <>
inline constexpr auto tendon::kPayload<faults::ForceRenamed> =
    faults::DescribeForce<faults::ForceRenamed>("x");
template <>
inline constexpr auto tendon::kPayload<faults::ForceWithMore> = tendon::Describe(
    "faults.Force", tendon::Field{"fx", &faults::ForceWithMore::fx, "N"},
    faults::kFy<faults::ForceWithMore>, faults::kTorque<faults::ForceWithMore>,
    faults::kFrame<faults::ForceWithMore>, tendon::Field{"more", &faults::ForceWithMore::more});
template <>
inline constexpr auto tendon::kPayload<faults::ForceWithLess> =
    tendon::Describe("faults.Force", tendon::Field{"fx", &faults::ForceWithLess::fx, "N"},
                     faults::kFy<faults::ForceWithLess>, faults::kTorque<faults::ForceWithLess>);
template <>
inline constexpr auto tendon::kPayload<faults::ForceInOtherOrder> = tendon::Describe(
    "faults.Force", faults::kFy<faults::ForceInOtherOrder>,
    tendon::Field{"fx", &faults::ForceInOtherOrder::fx, "N"},
    faults::kTorque<faults::ForceInOtherOrder>, faults::kFrame<faults::ForceInOtherOrder>);
