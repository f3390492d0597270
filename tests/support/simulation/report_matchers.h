#pragma once

#include <gmock/gmock.h>
#include <support/simulation/simulation.h>

#include <cstddef>
#include <string>

namespace tendon::simulation {

/// Nothing failed in all that the limits allow, which was more than so many executions.
inline auto Passes(std::size_t executions = 0) {
  return testing::AllOf(testing::Field("failure", &Report::failure, testing::IsEmpty()),
                        testing::Field("is_complete", &Report::is_complete, true),
                        testing::Field("executions", &Report::executions, testing::Gt(executions)));
}

/// An execution failed, and said so.
inline auto FailsWith(const std::string& sentence) {
  return testing::Field("failure", &Report::failure, testing::HasSubstr(sentence));
}

}  // namespace tendon::simulation
