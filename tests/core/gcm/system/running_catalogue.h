#pragma once

#include <gtest/gtest.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/system/plan.h>
#include <tendon/gcm/system_file.h>
#include <tests/core/gcm/samples.h>

#include <string>
#include <utility>
#include <vector>

namespace tendon::test {

/// A catalogue that a test fills.
class CatalogBuilder {
 public:
  CatalogBuilder& Process(const std::string& name, const std::vector<ComponentDescription>& parts,
                          ProcessState state = ProcessState::kAlive) {
    ProcessDescription process = ProcessNamed(name, ++instance_);
    process.state = state;
    Add({.kind = CatalogueChange::Kind::kProcess, .process = name, .processes = {process}});
    for (const auto& part : parts) {
      Add({.kind = CatalogueChange::Kind::kComponent, .process = name, .components = {part}});
    }
    return *this;
  }

  /// A second connection of a required interface replaces the first.
  CatalogBuilder& Connection(const InterfaceName& required, const InterfaceName& provided,
                             ConnectionState state = ConnectionState::kActive,
                             const std::string& reason = "") {
    const auto* before = catalogue_.FindConnection(required);
    const ConnectionDescription made{.id = before == nullptr ? ++connection_ : before->id,
                                     .required = required,
                                     .provided = provided,
                                     .state = state,
                                     .reason = reason};
    Add({.kind = CatalogueChange::Kind::kConnection,
         .process = required.process,
         .connections = {made}});
    return *this;
  }

  [[nodiscard]] const Catalogue& catalogue() const { return catalogue_; }

 private:
  void Add(CatalogueChange change) {
    change.revision = catalogue_.revision() + 1;
    ASSERT_TRUE(catalogue_.Apply(change));
  }

  Catalogue catalogue_;
  std::uint64_t instance_ = 0;
  std::uint64_t connection_ = 0;
};

inline const InterfaceName kNeeded("desk", "teleoperation", "Robot");
inline const InterfaceName kOffered("robot", "arm", "Control");

/// Returns a desk and a robot that are connected.
inline CatalogBuilder RunningDemo() {
  CatalogBuilder demo;
  ComponentDescription teleoperation = Teleoperation();
  teleoperation.library = "teleoperation";
  ComponentDescription arm = Arm();
  arm.configuration = R"({"noise":0})";
  demo.Process("robot", {arm, Arm("spare")})
      .Process("desk", {teleoperation})
      .Connection(kNeeded, kOffered);
  return demo;
}

inline std::vector<std::string> TextsOf(const Plan& plan) {
  std::vector<std::string> texts;
  for (const PlanStep& step : plan.steps) texts.push_back(ToString(step));
  return texts;
}

}  // namespace tendon::test
