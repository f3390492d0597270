#include <tendon/base/log.h>
#include <tendon/middleware/requests/pending_requests.h>

#include <exception>
#include <utility>
#include <vector>

namespace tendon {

std::uint64_t PendingRequests::Add(std::chrono::milliseconds timeout, Handler& handler) {
  const std::scoped_lock lock(mutex_);
  if (finished_) return 0;
  pending_.emplace(++last_, Pending{SteadyClock().Now() + timeout, timeout, std::move(handler)});
  return last_;
}

void PendingRequests::Withdraw(std::uint64_t request) {
  const std::scoped_lock lock(mutex_);
  pending_.erase(request);
}

bool PendingRequests::Finish(std::uint64_t request, Result<Bytes> outcome) {
  std::unique_lock lock(mutex_);
  auto pending = pending_.extract(request);
  lock.unlock();
  if (pending.empty()) return false;
  CallGuarded("request", [&] { pending.mapped().handler(std::move(outcome)); });
  return true;
}

void PendingRequests::OnAnswer(std::uint64_t request, Result<Bytes> answer) {
  if (Finish(request, std::move(answer))) return;
  const std::scoped_lock lock(mutex_);
  ++late_;
}

void PendingRequests::Expire(SteadyTime now, const std::string& peer) {
  std::vector<std::pair<std::uint64_t, std::chrono::milliseconds>> due;
  {
    const std::scoped_lock lock(mutex_);
    for (const auto& [request, pending] : pending_) {
      if (pending.deadline <= now) due.emplace_back(request, pending.timeout);
    }
  }
  for (const auto& [request, timeout] : due) Finish(request, NoAnswer(peer, timeout));
}

void PendingRequests::FinishAll(const Error& reason) {
  std::unique_lock lock(mutex_);
  finished_ = true;
  const auto pending = std::exchange(pending_, {});
  lock.unlock();
  for (const auto& [request, one] : pending) {
    CallGuarded("request", [&handler = one.handler, &reason] { handler(reason); });
  }
}

std::uint64_t PendingRequests::late_answers() const {
  const std::scoped_lock lock(mutex_);
  return late_;
}

Error NoAnswer(const std::string& peer, std::chrono::milliseconds timeout) {
  return {ErrorCode::kTimeout, "no answer from " + peer + " within " +
                                   std::to_string(timeout.count()) + " ms; outcome unknown"};
}

void LogFailure(const std::string& peer) {
  try {
    throw;
  } catch (const std::exception& failure) {
    Log(LogLevel::kError, "channel", peer + ": " + failure.what());
  } catch (...) {
    Log(LogLevel::kError, "channel", peer + ": something was thrown that is no std::exception");
  }
}

}  // namespace tendon
