#include <tendon/ice/sequence_size_check.h>

#include <cstdint>
#include <utility>
#include <vector>

/// Replaces the function with this name in Ice's library. The dynamic linker uses the first
/// definition, also for calls inside the library. This does not work if the library was linked with
/// -Bsymbolic-functions.
///
/// Up to version 3.7.11, the function of Ice adds in 32 bits, so a size near 2^31 passes the check.
/// Ice calls the function for the facet in the header of a request, before it calls a servant. With
/// a size near 2^31, Ice allocates 64 GiB, or the connection hangs forever.
Ice::Int Ice::InputStream::readAndCheckSeqSize(Int minSize) {
  const Int size = readSize();
  const std::int64_t left = b.end() - i;
  if (std::int64_t{size} * minSize > left) throw UnmarshalOutOfBoundsException("tendon", 0);
  return size;
}

namespace tendon::ice {

bool RefusesImpossibleSizes(const std::shared_ptr<Ice::Communicator>& communicator) {
  const std::vector<Ice::Byte> two_gigabytes{255, 255, 255, 255, 127};
  Ice::InputStream stream(communicator, two_gigabytes);
  std::pair<const Ice::Byte*, const Ice::Byte*> unread;  // holds two pointers, not the bytes
  try {
    stream.read(unread);
    return false;
  } catch (const Ice::UnmarshalOutOfBoundsException&) {
    return true;
  }
}

}  // namespace tendon::ice
