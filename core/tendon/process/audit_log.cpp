#include <tendon/process/audit_log.h>

#include <tendon/base/text.h>

#include <chrono>

namespace tendon {
namespace {

constexpr LogLimiter::Rate kRate{.burst = 50, .interval = std::chrono::milliseconds(100)};

void WriteLine(LogLevel level, const std::string& line) {
  LogDeferred(std::chrono::system_clock::now(), level, "audit", line);
}

}  // namespace

AuditLog::AuditLog() : limiter_(kRate) {}

AuditLog::~AuditLog() { WriteSuppressed(SteadyTime::max()); }

void AuditLog::Write(const std::string& who, LogLevel level, const std::string& line) {
  const SteadyTime now = SteadyClock().Now();
  const std::scoped_lock lock(mutex_);
  WriteSuppressed(now);
  if (limiter_.Admit(who, level, now)) WriteLine(level, line);
}

std::string NameAndRole(const Channel& channel, Role role) {
  return Printable(channel.peer().name, 64) + " (" + std::string(ToString(role)) + ", " +
         channel.peer_address() + ")";
}

void AuditLog::WriteSuppressed(SteadyTime now) {
  if (!limiter_.owes()) return;
  for (const LogLimiter::SuppressedCount& one : limiter_.TakeSuppressed(now)) {
    WriteLine(one.level, "and " + std::to_string(one.count) + " more of " + one.source);
  }
}

}  // namespace tendon
