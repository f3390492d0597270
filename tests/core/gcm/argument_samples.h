#pragma once

#include <tendon/interface/interface_description.h>
#include <tendon/payload/schema.h>

#include <cstdint>
#include <string>

namespace tendon::test {

inline MemberDescription MemberOf(const std::string& name, CommandKind kind) {
  MemberDescription member;
  member.name = name;
  member.signature.kind = kind;
  return member;
}

inline Schema Numbers(std::uint32_t length) {
  return Schema::Array(Schema(Schema::Kind::kFloat64), length);
}

/// Returns the argument of the demo arm's MoveTo, with fewer joints.
inline Schema JointGoalSchema(std::uint32_t joints) {
  return Schema::Structure("arm.JointGoal", {{"position", "rad", Numbers(joints)},
                                             {"duration", "s", Schema(Schema::Kind::kFloat64)}});
}

/// Returns the result of reading the demo arm's joints.
inline Schema JointStateSchema(std::uint32_t joints) {
  return Schema::Structure("arm.JointState", {{"position", "rad", Numbers(joints)},
                                              {"velocity", "rad/s", Numbers(joints)}});
}

}  // namespace tendon::test
