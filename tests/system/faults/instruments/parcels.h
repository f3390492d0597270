#pragma once

#include <tendon/base/os/process.h>
#include <tendon/interface/function.h>
#include <tendon/task/periodic_task.h>
#include <tests/system/faults/instruments/journal.h>

#include <chrono>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace faults {

using namespace std::chrono_literals;

/// A payload of any size, whose bytes are all equal.
using Parcel = std::vector<std::uint8_t>;
inline constexpr std::uint8_t kFilling = 7;

/// Sends parcels of the requested size, and reports the outcome of each parcel.
class Sender final : public tendon::PeriodicTask {
 public:
  explicit Sender(std::string name) : PeriodicTask(std::move(name), 5ms) {
    AddRequiredInterface("Parcels").AddFunction(take_, "Take");
    AddProvidedInterface("Control").AddCommandWriteReturn(&Sender::Send, this, "Send");
  }

 private:
  void Run() override { ProcessQueuedCommands(); }

  void Send(std::uint64_t size, std::string& said) {
    said = std::string(ToString(take_(Parcel(size, kFilling))));
  }

  tendon::WriteFunction<Parcel> take_;
};

/// Writes the size of each complete parcel to the journal.
class Receiver final : public tendon::PeriodicTask {
 public:
  using Configuration = JournalPlace;

  Receiver(std::string name, const Configuration& place)
      : PeriodicTask(std::move(name), 5ms),
        taken_(place.folder, "taken", tendon::os::RandomNumber()) {
    AddProvidedInterface("Parcels").AddCommandWrite(&Receiver::Take, this, "Take");
  }

 private:
  void Run() override { ProcessQueuedCommands(); }

  void Take(const Parcel& parcel) {
    const bool is_whole = !parcel.empty() && parcel.front() == kFilling &&
                          std::memcmp(parcel.data(), parcel.data() + 1, parcel.size() - 1) == 0;
    taken_.Add((is_whole ? "whole " : "damaged ") + std::to_string(parcel.size()));
  }

  Journal taken_;
};

}  // namespace faults
