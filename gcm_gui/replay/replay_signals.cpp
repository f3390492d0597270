#include <gcm_gui/replay/replay_signals.h>

#include <algorithm>
#include <utility>

namespace tendon::gui {
namespace {

// Samples of all numbers together. This is enough for one hour of one number at 1 kHz. No plot gets
// a longer time at once.
constexpr std::size_t kMaxWaiting = std::size_t{1} << 22;

}  // namespace

bool ReplaySignals::begin(const QString& column, const std::shared_ptr<ColumnFeed>& feed) {
  Q_EMIT columnWanted(column.toStdString(), feed);
  return true;
}

QStringList ReplaySignals::subscribed() const {
  QStringList signals_in_use;
  for (const auto& [path, column] : columns()) {
    for (const auto& [signal, user] : column.users) signals_in_use << signal;
  }
  return signals_in_use;
}

WantedColumns ReplaySignals::beginJump() {
  std::erase_if(columns(), [](const auto& entry) { return !entry.second.isUsed(); });
  next_.clear();
  std::size_t taps = 0;
  for (const auto& [path, column] : columns()) taps += column.users.size();
  const std::size_t most = kMaxWaiting / std::max<std::size_t>(taps, 1);
  WantedColumns wanted;
  for (const auto& [path, column] : columns()) {
    const auto next = std::make_shared<ColumnFeed>(most);
    for (const auto& [signal, user] : column.users) next->tap(user.field);
    next_[path] = next;
    wanted[path.toStdString()] = {next, !column.users.empty()};
  }
  return wanted;
}

void ReplaySignals::endJump() {
  for (auto& [path, next] : std::exchange(next_, {})) {
    if (const auto it = columns().find(path); it != columns().end()) it->second.feed = next;
  }
  Q_EMIT beganAgain();
}

}  // namespace tendon::gui
