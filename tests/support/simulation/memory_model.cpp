#include <support/simulation/memory_model.h>

#include <algorithm>
#include <cassert>

namespace tendon {
namespace {

bool Acquires(std::memory_order order) {
  return order != std::memory_order_relaxed && order != std::memory_order_release;
}

bool Releases(std::memory_order order) {
  return order == std::memory_order_release || order == std::memory_order_acq_rel ||
         order == std::memory_order_seq_cst;
}

template <typename Container>
void TakeMaxima(Container& mine, const Container& other) {
  for (std::size_t i = 0; i < other.size(); ++i) mine[i] = std::max(mine[i], other[i]);
}

}  // namespace

void MemoryModel::View::Join(const View& other) {
  if (oldest.size() < other.oldest.size()) oldest.resize(other.oldest.size());
  TakeMaxima(oldest, other.oldest);
  TakeMaxima(clock, other.clock);
}

std::uint32_t MemoryModel::View::Oldest(Location location) const {
  return location < oldest.size() ? oldest[location] : 0;
}

void MemoryModel::View::See(Location location, std::size_t index) {
  if (oldest.size() <= location) oldest.resize(location + 1);
  oldest[location] = std::max(oldest[location], static_cast<std::uint32_t>(index));
}

MemoryModel::Location MemoryModel::AddAtomic(Thread thread, std::uint64_t value) {
  atomics_.push_back({Value{value, threads_[thread].current}});
  return atomics_.size() - 1;
}

MemoryModel::Location MemoryModel::AddPlain() {
  plains_.emplace_back();
  return plains_.size() - 1;
}

std::size_t MemoryModel::Choices(Thread thread, Location location) const {
  return atomics_[location].size() - threads_[thread].current.Oldest(location);
}

std::uint64_t MemoryModel::Load(Thread thread, Location location, std::memory_order order,
                                std::size_t choice) {
  assert(choice < Choices(thread, location));
  ThreadState& state = threads_[thread];
  const std::size_t index = atomics_[location].size() - 1 - choice;
  const Value& value = atomics_[location][index];
  state.current.See(location, index);
  (Acquires(order) ? state.current : state.read).Join(value.view);
  return value.bits;
}

void MemoryModel::Store(Thread thread, Location location, std::uint64_t value,
                        std::memory_order order) {
  if (order == std::memory_order_seq_cst) Fence(thread, order);
  ThreadState& state = threads_[thread];
  const std::size_t index = atomics_[location].size();
  state.current.See(location, index);
  View view = Releases(order) ? state.current : state.released;
  view.See(location, index);
  atomics_[location].push_back({value, std::move(view)});
}

void MemoryModel::Fence(Thread thread, std::memory_order order) {
  ThreadState& state = threads_[thread];
  if (Acquires(order)) state.current.Join(state.read);
  if (order == std::memory_order_seq_cst) {
    state.current.Join(total_order_);
    total_order_ = state.current;
  }
  if (Releases(order)) state.released = state.current;
}

void MemoryModel::ProcessBarrier() {
  for (Thread thread = 0; thread < kMaxThreads; ++thread) {
    Fence(thread, std::memory_order_seq_cst);
  }
  for (Thread thread = 0; thread < kMaxThreads; ++thread) {
    Fence(thread, std::memory_order_seq_cst);
  }
}

bool MemoryModel::ReadPlain(Thread thread, Location location) {
  auto& clock = threads_[thread].current.clock;
  Plain& plain = plains_[location];
  plain.reads[thread] = ++clock[thread];
  return std::ranges::equal(plain.writes, clock, std::less_equal{});
}

bool MemoryModel::WritePlain(Thread thread, Location location) {
  auto& clock = threads_[thread].current.clock;
  Plain& plain = plains_[location];
  plain.writes[thread] = ++clock[thread];
  return std::ranges::equal(plain.writes, clock, std::less_equal{}) &&
         std::ranges::equal(plain.reads, clock, std::less_equal{});
}

void MemoryModel::Fork(Thread parent, Thread child) {
  threads_[child].current.Join(threads_[parent].current);
}

void MemoryModel::Join(Thread parent, Thread child) {
  threads_[parent].current.Join(threads_[child].current);
}

std::uint64_t MemoryModel::Newest(Location location) const {
  return atomics_[location].back().bits;
}

}  // namespace tendon
