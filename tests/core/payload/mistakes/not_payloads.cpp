#include <tendon/interface/function.h>

#include <map>
#include <memory>
#include <span>
#include <string_view>

// Each kind of type that cannot be sent has its own sentence.

enum class Wide : std::uint64_t {};

struct Unique {
  int number = 0;
  Unique() = default;
  Unique(const Unique&) = delete;
};
template <>
inline constexpr auto tendon::kPayload<Unique> =
    tendon::Describe("test.Unique", tendon::Field{"number", &Unique::number});

struct Row {
  // error: T is a C array
  double position[7] = {};
  // error: T is a pointer
  const char* name = nullptr;
  // error: T is a character
  std::vector<wchar_t> text;
};
template <>
inline constexpr auto tendon::kPayload<Row> =
    tendon::Describe("test.Row", tendon::Field{"position", &Row::position},
                     tendon::Field{"name", &Row::name}, tendon::Field{"text", &Row::text});

struct Component {
  // error: T is a character
  tendon::WriteFunction<char> character;
  // error: T is a pointer
  tendon::WriteFunction<int*> pointer;
  // error: T is a pointer
  tendon::WriteFunction<std::vector<std::shared_ptr<int>>> pointers;
  // error: T is a view
  tendon::WriteFunction<std::string_view> text;
  // error: T is a view
  tendon::WriteFunction<std::span<double>> span;
  // error: T is a long double
  tendon::WriteFunction<long double> wide;
  // error: T is an enum of more than 32 bits
  tendon::WriteFunction<Wide> number;
  // error: T is const or a reference
  tendon::WriteFunction<const double> constant;
  // error: T is not described
  tendon::WriteFunction<std::map<int, int>> map;
  // error: T has no default value, or it cannot be copied
  tendon::WriteFunction<Unique> unique;
  tendon::WriteFunction<Row> row;
};
