#pragma once

#include <tendon/payload/payload.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Payloads that together have every kind of field, and difficult alignments.
namespace sample {

enum class Mode : std::int8_t { kOff = 0, kTracking = 5, kFault = -1 };
enum class Plain : std::uint8_t { kSmall = 1, kLarge = 200 };

struct JointState {
  std::array<double, 7> position{};
  std::array<double, 7> velocity{};

  bool operator==(const JointState&) const = default;
};

struct Point {
  double x = 0;
  double y = 0;
  double z = 0;

  bool operator==(const Point&) const = default;
};

/// The offset of every field differs from the sum of the sizes before it.
struct Ragged {
  bool first = false;
  double wide = 0;
  std::uint8_t small = 0;
  std::int16_t middle = 0;
  bool second = false;
  float real = 0;
  std::uint8_t last = 0;

  bool operator==(const Ragged&) const = default;
};

struct Numbers {
  std::int8_t i8 = 0;
  std::uint64_t u64 = 0;
  std::uint8_t u8 = 0;
  std::int64_t i64 = 0;
  std::int16_t i16 = 0;
  std::uint32_t u32 = 0;
  std::uint16_t u16 = 0;
  std::int32_t i32 = 0;
  std::byte octet{};
  float f32 = 0;
  bool flag = false;
  double f64 = 0;

  bool operator==(const Numbers&) const = default;
};

/// A type of fixed size, with structures whose encoded size depends on their position.
struct Fixed {
  bool flag = false;
  std::array<Ragged, 3> ragged{};
  Mode mode = Mode::kOff;
  std::uint8_t odd = 0;
  std::chrono::milliseconds period{};
  std::array<std::array<float, 2>, 3> grid{};
  tendon::None nothing;
  std::array<bool, 3> flags{};
  Plain plain = Plain::kSmall;
  std::array<Mode, 2> modes{};

  bool operator==(const Fixed&) const = default;
};

struct Dynamic {
  std::string name;
  Ragged ragged;
  std::vector<std::byte> raw;
  std::vector<double> samples;
  bool flag = false;
  std::vector<Point> points;
  std::vector<std::string> words;
  std::vector<bool> bits;
  std::vector<std::vector<std::uint16_t>> table;
  std::array<std::string, 2> pair;
  std::vector<Ragged> rags;
  std::vector<std::array<double, 3>> triples;
  std::vector<Mode> modes;
  std::vector<std::chrono::nanoseconds> times;
  std::vector<tendon::None> nothings;
  std::uint8_t last = 0;
  std::vector<std::uint64_t> end;

  bool operator==(const Dynamic&) const = default;
};

}  // namespace sample

template <>
inline constexpr auto tendon::kPayload<sample::Mode> =
    tendon::DescribeEnum("sample.Mode", tendon::Enumerator{"off", sample::Mode::kOff},
                         tendon::Enumerator{"tracking", sample::Mode::kTracking},
                         tendon::Enumerator{"fault", sample::Mode::kFault});

template <>
inline constexpr auto tendon::kPayload<sample::JointState> = tendon::Describe(
    "sample.JointState", tendon::Field{"position", &sample::JointState::position, "rad"},
    tendon::Field{"velocity", &sample::JointState::velocity, "rad/s"});

template <>
inline constexpr auto tendon::kPayload<sample::Point> =
    tendon::Describe("sample.Point", tendon::Field{"x", &sample::Point::x},
                     tendon::Field{"y", &sample::Point::y}, tendon::Field{"z", &sample::Point::z});

template <>
inline constexpr auto tendon::kPayload<sample::Ragged> = tendon::Describe(
    "sample.Ragged", tendon::Field{"first", &sample::Ragged::first},
    tendon::Field{"wide", &sample::Ragged::wide, "mm"},
    tendon::Field{"small", &sample::Ragged::small},
    tendon::Field{"middle", &sample::Ragged::middle},
    tendon::Field{"second", &sample::Ragged::second}, tendon::Field{"real", &sample::Ragged::real},
    tendon::Field{"last", &sample::Ragged::last});

template <>
inline constexpr auto tendon::kPayload<sample::Numbers> = tendon::Describe(
    "sample.Numbers", tendon::Field{"i8", &sample::Numbers::i8},
    tendon::Field{"u64", &sample::Numbers::u64}, tendon::Field{"u8", &sample::Numbers::u8},
    tendon::Field{"i64", &sample::Numbers::i64}, tendon::Field{"i16", &sample::Numbers::i16},
    tendon::Field{"u32", &sample::Numbers::u32}, tendon::Field{"u16", &sample::Numbers::u16},
    tendon::Field{"i32", &sample::Numbers::i32}, tendon::Field{"octet", &sample::Numbers::octet},
    tendon::Field{"f32", &sample::Numbers::f32}, tendon::Field{"flag", &sample::Numbers::flag},
    tendon::Field{"f64", &sample::Numbers::f64});

template <>
inline constexpr auto tendon::kPayload<sample::Fixed> = tendon::Describe(
    "sample.Fixed", tendon::Field{"flag", &sample::Fixed::flag},
    tendon::Field{"ragged", &sample::Fixed::ragged, "m"},
    tendon::Field{"mode", &sample::Fixed::mode}, tendon::Field{"odd", &sample::Fixed::odd},
    tendon::Field{"period", &sample::Fixed::period},
    tendon::Field{"grid", &sample::Fixed::grid, "K"},
    tendon::Field{"nothing", &sample::Fixed::nothing},
    tendon::Field{"flags", &sample::Fixed::flags}, tendon::Field{"plain", &sample::Fixed::plain},
    tendon::Field{"modes", &sample::Fixed::modes});

template <>
inline constexpr auto tendon::kPayload<sample::Dynamic> = tendon::Describe(
    "sample.Dynamic", tendon::Field{"name", &sample::Dynamic::name},
    tendon::Field{"ragged", &sample::Dynamic::ragged}, tendon::Field{"raw", &sample::Dynamic::raw},
    tendon::Field{"samples", &sample::Dynamic::samples, "N m"},
    tendon::Field{"flag", &sample::Dynamic::flag},
    tendon::Field{"points", &sample::Dynamic::points},
    tendon::Field{"words", &sample::Dynamic::words}, tendon::Field{"bits", &sample::Dynamic::bits},
    tendon::Field{"table", &sample::Dynamic::table}, tendon::Field{"pair", &sample::Dynamic::pair},
    tendon::Field{"rags", &sample::Dynamic::rags},
    tendon::Field{"triples", &sample::Dynamic::triples},
    tendon::Field{"modes", &sample::Dynamic::modes},
    tendon::Field{"times", &sample::Dynamic::times},
    tendon::Field{"nothings", &sample::Dynamic::nothings},
    tendon::Field{"last", &sample::Dynamic::last}, tendon::Field{"end", &sample::Dynamic::end});
