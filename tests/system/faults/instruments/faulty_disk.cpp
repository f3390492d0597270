#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

/// Preloaded into a program, this library simulates a disk that writes at most a few bytes at a
/// time. From the position TENDON_TEST_BAD_PLACE of a file on, if it is in the environment, nothing
/// can be written.
extern "C" ssize_t pwritev(int file, const iovec* parts, int count, off_t offset) {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): read only
  static const char* const bad_place = std::getenv("TENDON_TEST_BAD_PLACE");
  constexpr std::size_t kLargest = 1000;  // bytes
  std::size_t most = kLargest;
  if (bad_place != nullptr) {
    const off_t good = std::atoll(bad_place) - offset;
    if (good <= 0) {
      errno = EIO;
      return -1;
    }
    most = std::min(most, static_cast<std::size_t>(good));
  }
  const iovec* const end = parts + count;
  const iovec* const first =
      std::find_if(parts, end, [](const iovec& part) { return part.iov_len > 0; });
  if (first == end) return 0;
  return pwrite(file, first->iov_base, std::min(first->iov_len, most), offset);
}
