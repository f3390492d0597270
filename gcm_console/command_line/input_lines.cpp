#include <gcm_console/command_line/input_lines.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <iostream>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;

/// Returns true if the input has ended because of a read error. For standard input, the C++ library
/// does not report read errors.
bool IsBroken(const std::istream& in) {
  return in.bad() || (&in == &std::cin && std::ferror(stdin) != 0);
}

Error Broken() {
  return {ErrorCode::kInvalid,
          "the standard input could not be read completely: use a file or a pipe"};
}

}  // namespace

bool InputLines::Next(std::string& line) {
  constexpr std::size_t kLongest = std::size_t{1} << 20U;
  line.clear();
  auto* const buffer = in_.rdbuf();
  bool is_end = error_.has_value();
  try {
    while (!is_end && line.size() <= kLongest) {
      const int letter = buffer->sbumpc();
      is_end = letter == std::istream::traits_type::eof();
      if (letter == '\n') return true;
      if (!is_end) line += static_cast<char>(letter);
    }
  } catch (...) {
    in_.setstate(std::ios::badbit);
  }
  if (line.size() > kLongest) {
    error_ = {ErrorCode::kInvalid, "a line is longer than 1 MiB: check that the input is a text"};
  } else if (IsBroken(in_)) {
    error_ = Broken();
  }
  return !error_ && !line.empty();
}

tendon::Result<std::string> AllOf(std::istream& in) {
  constexpr std::size_t kMax = std::size_t{16} << 20U;
  std::string all;
  std::array<char, 65536> part{};
  while (all.size() <= kMax && in) {
    in.read(part.data(), part.size());
    all.append(part.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (all.size() > kMax)
    return Error{ErrorCode::kInvalid, "the input is over 16 MiB: give a smaller input"};
  if (IsBroken(in)) return Broken();
  return all;
}

}  // namespace console
