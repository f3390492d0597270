#include <tendon/proxy/network_thread.h>

#include <tendon/base/os/thread.h>

#include <utility>

namespace tendon {

NetworkThread::NetworkThread(std::string name)
    : name_(std::move(name)), thread_([this] { Run(); }) {}

NetworkThread::~NetworkThread() {
  stopping_.Set(true);
  Notify();
  thread_.join();
}

void NetworkThread::Add(NetworkJob& job) {
  {
    const std::scoped_lock turn(turn_);
    const std::scoped_lock lock(mutex_);
    jobs_.push_back(&job);
  }
  Notify();
}

void NetworkThread::Remove(NetworkJob& job) {
  const std::scoped_lock turn(turn_);
  const std::scoped_lock lock(mutex_);
  std::erase(jobs_, &job);
}

void NetworkThread::Run() {
  os::NameThisThread(name_);
  while (!stopping_.Get()) {
    SteadyTime next;
    while (Round(next) && !stopping_.Get()) {
    }
    wakeup_.WaitUntil(
        [&] {
          SteadyTime wanted;
          return stopping_.Get() || Round(wanted) || wanted < next;
        },
        next);
  }
}

bool NetworkThread::Round(SteadyTime& next) {
  constexpr std::chrono::seconds kLongest(1);
  const SteadyTime now = SteadyClock().Now();
  next = now + kLongest;
  bool more = false;
  std::unique_lock turn(turn_);
  const std::scoped_lock lock(mutex_);
  turn.unlock();
  for (NetworkJob* job : jobs_) more = job->Work(now, next) || more;
  return more;
}

}  // namespace tendon
