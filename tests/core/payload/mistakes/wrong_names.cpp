#include <tendon/payload/payload.h>

// Each description has one mistake.

struct Pair {
  int a = 0;
  int b = 0;
};
struct Limb {
  double position[7] = {};
};
class Closed {
  int a = 0;
};
struct Many {};

// error: given fewer names than T has members
constexpr auto kFewer = tendon::Describe<Pair>("test.Pair", "a");
// error: given more names than T has members
constexpr auto kMore = tendon::Describe<Pair>("test.Pair", "a", "b", "c");
// error: and std::array instead of a C array
constexpr auto kArray = tendon::Describe<Limb>("test.Limb", "position");
// error: given a class that is not an aggregate
constexpr auto kClosed = tendon::Describe<Closed>("test.Closed", "a");
// error: given more than 24 names
constexpr auto kMany =
    tendon::Describe<Many>("test.Many", "a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l",
                           "m", "n", "o", "p", "q", "r", "s", "t", "u", "v", "w", "x", "y");
