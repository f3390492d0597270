#pragma once

#include <benchmarks/case.h>

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <ostream>

namespace tendon::benchmark {

void PrintHeading(std::ostream& out);
/// A line of the table. Without an outcome if this machine cannot measure it.
void PrintLine(std::ostream& out, const Case& one, const std::optional<Outcome>& outcome);

/// id, what, unit, ours, floor, ratio, gate, stretch, holds, reaches_stretch, pairs, disturbed;
/// null where there is none.
nlohmann::json ToJson(const Case& one, const std::optional<Outcome>& outcome);

}  // namespace tendon::benchmark
