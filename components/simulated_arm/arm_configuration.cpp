#include <components/simulated_arm/arm_configuration.h>
#include <tendon/base/error.h>

#include <cmath>

namespace arm {
namespace {

constexpr double kLargest = 1e3;  // of any number here, in its unit: beyond it is a mistake

/// Written so that nothing holds for NaN.
void Require(bool condition, const std::string& component, const std::string& sentence) {
  if (!condition) {
    throw tendon::ConfigurationError("configuration of '" + component + "': " + sentence);
  }
}

std::string Element(const char* field, std::size_t joint, double value) {
  return std::string(field) + "[" + std::to_string(joint) + "] is " + std::to_string(value);
}

}  // namespace

void RequireValid(const ArmConfiguration& configuration, const std::string& component) {
  const auto& [home, lower, upper, velocity, acceleration, bandwidth, noise] = configuration;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const double low = lower[joint];
    const double high = upper[joint];
    Require(low >= -kLargest && low < high && high <= kLargest, component,
            Element("lower", joint, low) + ", which is not below " + Element("upper", joint, high));
    Require(low <= home[joint] && home[joint] <= high, component,
            Element("home", joint, home[joint]) + ", outside of lower and upper");
    Require(velocity[joint] > 0.0 && velocity[joint] <= kLargest, component,
            Element("velocity", joint, velocity[joint]) + ", expected more than 0 rad/s");
    Require(acceleration[joint] > 0.0 && acceleration[joint] <= kLargest, component,
            Element("acceleration", joint, acceleration[joint]) + ", expected more than 0 rad/s^2");
  }
  Require(bandwidth > 0.0 && bandwidth <= 500.0, component,
          "bandwidth is " + std::to_string(bandwidth) + ", expected 0 to 500 rad/s");
  Require(noise >= 0.0 && noise <= 1.0, component,
          "noise is " + std::to_string(noise) + ", expected 0 to 1 rad");
}

}  // namespace arm
