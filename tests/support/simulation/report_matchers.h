#pragma once

#include <gmock/gmock.h>
#include <support/simulation/simulation.h>

#include <cstddef>
#include <string>

namespace tendon::simulation {

/// Matches if no execution within the limits failed, and if there were more than `executions`.
inline auto Passes(std::size_t executions = 0) {
  return testing::AllOf(testing::Field("failure", &Report::failure, testing::IsEmpty()),
                        testing::Field("is_complete", &Report::is_complete, true),
                        testing::Field("executions", &Report::executions, testing::Gt(executions)));
}

/// Matches if an execution failed with this sentence.
inline auto FailsWith(const std::string& sentence) {
  return testing::Field("failure", &Report::failure, testing::HasSubstr(sentence));
}

}  // namespace tendon::simulation
