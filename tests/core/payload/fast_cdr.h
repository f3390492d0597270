#pragma once

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include <cstddef>
#include <vector>

namespace tendon::test {

/// Returns the bytes that Fast CDR writes in `write(Cdr&)`. DDS and ROS 2 would send the same
/// bytes.
template <typename Writer>
std::vector<std::byte> WrittenByFastCdr(Writer write) {
  std::vector<char> memory(65536);  // zeros, because Fast CDR does not write padding
  eprosima::fastcdr::FastBuffer buffer(memory.data(), memory.size());
  eprosima::fastcdr::Cdr cdr(buffer, eprosima::fastcdr::Cdr::LITTLE_ENDIANNESS,
                             eprosima::fastcdr::Cdr::DDS_CDR);
  write(cdr);
  const auto* first = reinterpret_cast<const std::byte*>(memory.data());
  return {first, first + cdr.getSerializedDataLength()};
}

}  // namespace tendon::test
