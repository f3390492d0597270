#pragma once

#include <tendon/payload/payload.h>

#include <string>
#include <vector>

/// The measurements of a machine.
namespace host {

/// The load of the processor in the last second.
struct Cpu {
  double total = 0.0;           ///< %, over all cores
  std::vector<double> cores{};  ///< %, of each core
};

struct Memory {
  double used = 0.0;   ///< MiB that are not available to new programs
  double total = 0.0;  ///< MiB
  double swap = 0.0;   ///< MiB of swap in use
};

/// The sum over all disks of the machine, in the last second.
struct Disk {
  double read = 0.0;     ///< MiB/s
  double written = 0.0;  ///< MiB/s
};

/// Network traffic in the last second.
struct Network {
  double received = 0.0;  ///< KiB/s, over all external interfaces
  double sent = 0.0;      ///< KiB/s, over all external interfaces
  double loopback = 0.0;  ///< KiB/s between programs of this machine
};

/// One thermometer.
struct Temperature {
  std::string sensor{};
  double value = 0.0;  ///< °C; NaN if there is no reading at the moment
};

struct Temperatures {
  std::vector<Temperature> sensors{};
};

}  // namespace host

template <>
inline constexpr auto tendon::kPayload<host::Cpu> =
    tendon::Describe("host.Cpu", tendon::Field{"total", &host::Cpu::total, "%"},
                     tendon::Field{"cores", &host::Cpu::cores, "%"});

template <>
inline constexpr auto tendon::kPayload<host::Memory> =
    tendon::Describe("host.Memory", tendon::Field{"used", &host::Memory::used, "MiB"},
                     tendon::Field{"total", &host::Memory::total, "MiB"},
                     tendon::Field{"swap", &host::Memory::swap, "MiB"});

template <>
inline constexpr auto tendon::kPayload<host::Disk> =
    tendon::Describe("host.Disk", tendon::Field{"read", &host::Disk::read, "MiB/s"},
                     tendon::Field{"written", &host::Disk::written, "MiB/s"});

template <>
inline constexpr auto tendon::kPayload<host::Network> =
    tendon::Describe("host.Network", tendon::Field{"received", &host::Network::received, "KiB/s"},
                     tendon::Field{"sent", &host::Network::sent, "KiB/s"},
                     tendon::Field{"loopback", &host::Network::loopback, "KiB/s"});

template <>
inline constexpr auto tendon::kPayload<host::Temperature> =
    tendon::Describe("host.Temperature", tendon::Field{"sensor", &host::Temperature::sensor},
                     tendon::Field{"value", &host::Temperature::value, "°C"});

template <>
inline constexpr auto tendon::kPayload<host::Temperatures> =
    tendon::Describe("host.Temperatures", tendon::Field{"sensors", &host::Temperatures::sensors});
