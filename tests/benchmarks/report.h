#pragma once

#include <benchmarks/case.h>

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <ostream>

namespace tendon::benchmark {

void PrintHeading(std::ostream& out);
/// Prints a line of the table. `outcome` is empty if this machine cannot measure the case.
void PrintLine(std::ostream& out, const Case& one, const std::optional<Outcome>& outcome);

/// Returns the keys id, what, unit, ours, floor, ratio, gate, stretch, holds, reaches_stretch,
/// pairs, disturbed. An unknown value is null.
nlohmann::json ToJson(const Case& one, const std::optional<Outcome>& outcome);

}  // namespace tendon::benchmark
