#pragma once

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include <cstddef>
#include <vector>

namespace tendon::test {

/// The bytes that Fast CDR writes in `write(Cdr&)`, as DDS and ROS 2 would send them.
template <typename Writer>
std::vector<std::byte> WrittenByFastCdr(Writer write) {
  std::vector<char> memory(65536);  // zero, since Fast CDR leaves padding as it finds it
  eprosima::fastcdr::FastBuffer buffer(memory.data(), memory.size());
  eprosima::fastcdr::Cdr cdr(buffer, eprosima::fastcdr::Cdr::LITTLE_ENDIANNESS,
                             eprosima::fastcdr::Cdr::DDS_CDR);
  write(cdr);
  const auto* first = reinterpret_cast<const std::byte*>(memory.data());
  return {first, first + cdr.getSerializedDataLength()};
}

}  // namespace tendon::test
