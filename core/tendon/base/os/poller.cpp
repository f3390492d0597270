#include <tendon/base/os/poller.h>

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <system_error>

namespace tendon::os {
namespace {

constexpr std::uint64_t kWakeKey = 0;

void Control(const Socket& poll, int operation, const Socket& socket, std::uint64_t key,
             Poller::Watch watch) {
  epoll_event event{};
  event.data.u64 = key;
  if (watch != Poller::Watch::kNothing) event.events = EPOLLIN;
  if (watch == Poller::Watch::kReadsAndWrites) event.events |= EPOLLOUT;
  epoll_ctl(poll.descriptor(), operation, socket.descriptor(), &event);
}

}  // namespace

Poller::Poller()
    : poll_(epoll_create1(EPOLL_CLOEXEC)), wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (poll_.descriptor() < 0 || wake_.descriptor() < 0) {
    throw std::system_error(errno, std::generic_category(), "cannot wait for sockets");
  }
  Control(poll_, EPOLL_CTL_ADD, wake_, kWakeKey, Watch::kReads);
}

void Poller::Add(const Socket& socket, std::uint64_t key, Watch watch) {
  Control(poll_, EPOLL_CTL_ADD, socket, key, watch);
}

void Poller::Change(const Socket& socket, std::uint64_t key, Watch watch) {
  Control(poll_, EPOLL_CTL_MOD, socket, key, watch);
}

void Poller::Remove(const Socket& socket) {
  Control(poll_, EPOLL_CTL_DEL, socket, kWakeKey, Watch::kNothing);
}

std::span<const Poller::Event> Poller::Wait(std::chrono::milliseconds timeout) {
  constexpr int kMax = 64;
  std::array<epoll_event, kMax> ready{};
  events_.clear();
  const int count =
      epoll_wait(poll_.descriptor(), ready.data(), kMax, static_cast<int>(timeout.count()));
  for (int i = 0; i < count; ++i) {
    const epoll_event& event = ready[static_cast<std::size_t>(i)];
    if (event.data.u64 == kWakeKey) {
      std::uint64_t ignored = 0;
      (void)!read(wake_.descriptor(), &ignored, sizeof(ignored));
      continue;
    }
    const bool has_ended = (event.events & (EPOLLERR | EPOLLHUP)) != 0;
    events_.push_back({event.data.u64, has_ended || (event.events & EPOLLIN) != 0,
                       (event.events & EPOLLOUT) != 0});
  }
  return events_;
}

void Poller::Wake() {
  const std::uint64_t one = 1;
  (void)!write(wake_.descriptor(), &one, sizeof(one));
}

}  // namespace tendon::os
