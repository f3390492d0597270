#include <gcm_console/feeds/query_throttle.h>

#include <algorithm>
#include <string>

namespace console {

using tendon::InterfaceName;
using tendon::SteadyTime;

std::vector<InterfaceName> QueryThrottle::Begin(const std::vector<InterfaceName>& there,
                                                SteadyTime now) {
  const std::scoped_lock lock(mutex_);
  for (auto& [required, query] : queries_) query.is_there = false;
  for (const InterfaceName& required : there) queries_[required].is_there = true;
  const SteadyTime due = now - kBetween;
  std::erase_if(queries_, [due](const auto& one) {
    return !one.second.is_there && !one.second.is_under_way && one.second.asked <= due;
  });

  std::map<std::string, std::size_t> under_way;  // by process
  std::size_t all_under_way = 0;
  std::vector<decltype(queries_)::value_type*> waiting;
  for (auto& one : queries_) {
    if (one.second.is_under_way) {
      ++under_way[one.first.process];
      ++all_under_way;
    } else if (one.second.is_there && one.second.asked <= due) {
      waiting.push_back(&one);
    }
  }
  std::ranges::stable_sort(waiting, {}, [](const auto* one) { return one->second.asked; });

  std::vector<InterfaceName> begun;
  for (auto* const one : waiting) {
    if (all_under_way >= kMaxAtOnce) break;
    std::size_t& of_process = under_way[one->first.process];
    if (of_process >= kMaxOfOne) continue;
    ++of_process;
    ++all_under_way;
    one->second.asked = now;
    one->second.is_under_way = true;
    begun.push_back(one->first);
  }
  return begun;
}

void QueryThrottle::End(const InterfaceName& required) {
  const std::scoped_lock lock(mutex_);
  const auto found = queries_.find(required);
  if (found != queries_.end()) found->second.is_under_way = false;
}

}  // namespace console
