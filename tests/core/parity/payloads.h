#pragma once

#include <tendon/payload/codec.h>
#include <tendon/payload/eigen.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace tendon_test {

using Joints = std::array<double, 7>;
enum class Frame : std::int32_t { kBase, kTool };

/// A described structure of fixed size.
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Frame frame = Frame::kBase;
  bool is_reachable = false;
};

/// A described structure whose values vary in size.
struct Scan {
  std::string sensor;
  std::vector<Pose> poses;
};

/// The result of a filter: the size of its payload, and the thread in which the filter ran.
struct Filtered {
  std::uint64_t bytes = 0;
  std::uint64_t thread = 0;
};

}  // namespace tendon_test

template <>
inline constexpr auto tendon::kPayload<tendon_test::Frame> =
    tendon::DescribeEnum("test.Frame", tendon::Enumerator{"base", tendon_test::Frame::kBase},
                         tendon::Enumerator{"tool", tendon_test::Frame::kTool});
template <>
inline constexpr auto tendon::kPayload<tendon_test::Pose> =
    tendon::Describe("test.Pose", tendon::Field{"position", &tendon_test::Pose::position, "m"},
                     tendon::Field{"frame", &tendon_test::Pose::frame},
                     tendon::Field{"is_reachable", &tendon_test::Pose::is_reachable});
template <>
inline constexpr auto tendon::kPayload<tendon_test::Scan> =
    tendon::Describe("test.Scan", tendon::Field{"sensor", &tendon_test::Scan::sensor},
                     tendon::Field{"poses", &tendon_test::Scan::poses});
template <>
inline constexpr auto tendon::kPayload<tendon_test::Filtered> =
    tendon::Describe("test.Filtered", tendon::Field{"bytes", &tendon_test::Filtered::bytes},
                     tendon::Field{"thread", &tendon_test::Filtered::thread});

namespace tendon_test {

inline void Fill(Joints& joints, int seed) { joints.fill(seed + 0.25); }
inline void Fill(Eigen::Vector3d& vector, int seed) {
  vector = {seed + 0.5, seed - 0.5, seed * 2.0};
}
inline void Fill(Pose& pose, int seed) {
  Fill(pose.position, seed);
  pose.frame = seed % 2 == 0 ? Frame::kBase : Frame::kTool;
  pose.is_reachable = seed % 3 == 0;
}
inline void Fill(std::string& text, int seed) {
  text.assign(static_cast<std::size_t>(seed % 50), 'a');
  text += std::to_string(seed);
}
inline void Fill(std::vector<double>& numbers, int seed) {
  numbers.assign(static_cast<std::size_t>(seed % 20), seed + 0.75);
  numbers.push_back(seed);
}
inline void Fill(Eigen::VectorXd& vector, int seed) {
  vector = Eigen::VectorXd::LinSpaced(seed % 20 + 1, seed, seed + 1);
}
inline void Fill(Scan& scan, int seed) {
  Fill(scan.sensor, seed);
  scan.poses.resize(static_cast<std::size_t>(seed % 4));
  for (Pose& pose : scan.poses) Fill(pose, seed);
}

/// A value that is different for each seed.
template <typename P>
P Sample(int seed) {
  P value;
  Fill(value, seed);
  return value;
}

/// The maximum size of a sample of a dynamic payload.
inline constexpr std::size_t kColumnCapacity = 512;

/// Compares the encoded bytes, because Eigen cannot compare vectors of different sizes.
template <typename P>
std::vector<std::byte> BytesOf(const P& value) {
  std::vector<std::byte> bytes;
  tendon::Encode(value, bytes);
  return bytes;
}
template <typename P>
bool IsSample(const P& value, int seed) {
  return BytesOf(value) == BytesOf(Sample<P>(seed));
}

/// A list of all payloads of these tests: first the fixed ones, then the dynamic ones.
template <template <typename...> typename List>
using ForPayloads =
    List<Joints, Eigen::Vector3d, Pose, std::string, std::vector<double>, Eigen::VectorXd, Scan>;

}  // namespace tendon_test
