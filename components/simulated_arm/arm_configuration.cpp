#include <components/simulated_arm/arm_configuration.h>

#include <tendon/base/error.h>
#include <tendon/payload/numeric_value.h>

namespace arm {
namespace {

/// Throws if `condition` is false. The condition must be false for NaN.
void Require(bool condition, const std::string& component, const std::string& sentence) {
  if (!condition) {
    throw tendon::ConfigurationError("configuration of '" + component + "': " + sentence);
  }
}

std::string Text(double value) { return ToString(tendon::NumericValue(value)); }

std::string Element(const char* field, std::size_t joint, double value) {
  return std::string(field) + "[" + std::to_string(joint) + "] is " + Text(value);
}

/// True for a valid limit of velocity or acceleration.
bool IsLimit(double value) { return value >= kMinLimit && value <= kGreatestLimit; }

}  // namespace

void RequireValid(const ArmConfiguration& configuration, const std::string& component) {
  const auto& [home, lower, upper, velocity, acceleration, bandwidth, noise] = configuration;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const double low = lower[joint];
    const double high = upper[joint];
    Require(low >= -kLargestAngle && low < high && high <= kLargestAngle, component,
            Element("lower", joint, low) + ", which is not below " + Element("upper", joint, high));
    Require(low <= home[joint] && home[joint] <= high, component,
            Element("home", joint, home[joint]) + ", expected " + Text(low) + " to " + Text(high) +
                " rad, the lower and the upper limit of this joint");
    Require(IsLimit(velocity[joint]), component,
            Element("velocity", joint, velocity[joint]) + ", expected 0.001 to 1000 rad/s");
    Require(
        IsLimit(acceleration[joint]), component,
        Element("acceleration", joint, acceleration[joint]) + ", expected 0.001 to 1000 rad/s^2");
  }
  Require(bandwidth >= kMinBandwidth && bandwidth <= kMaxBandwidth, component,
          "bandwidth is " + Text(bandwidth) + ", expected 0.001 to 500 rad/s");
  Require(noise >= 0.0 && noise <= kMaxNoise, component,
          "noise is " + Text(noise) + ", expected 0 to 1 rad");
}

}  // namespace arm
