#include <tendon/gcm/initial_arguments.h>

#include <tendon/gcm/lookup.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

namespace tendon {
namespace {

/// The subject of a command name: "Gains" for "SetGains" and "GetGains".
std::string_view Subject(std::string_view name) {
  const bool has_verb = name.starts_with("Set") || name.starts_with("Get");
  return has_verb ? name.substr(3) : name;
}

bool IsStructure(const std::string& type) { return type.find('.') != std::string::npos; }

/// Finds the read command that returns the whole argument. Returns an empty name if none does.
std::string WholeRead(const ProvidedDescription& of, const MemberDescription& command) {
  std::string found;
  for (const MemberDescription& one : of.commands) {
    const bool fits =
        one.signature.kind == CommandKind::kRead && one.signature.out == command.signature.in;
    if (!fits) continue;
    if (Subject(one.name) == Subject(command.name)) return one.name;
    // Only a structure may match by its type alone, because many commands return plain numbers of
    // the same type.
    if (found.empty() && IsStructure(command.in_type)) found = one.name;
  }
  return found;
}

bool MayBeLarge(const Schema& schema) {
  constexpr std::size_t kSmall = 4096;
  using Kind = Schema::Kind;
  if (schema.kind() == Kind::kSequence || schema.kind() == Kind::kString) return true;
  if (schema.kind() == Kind::kArray && MayBeLarge(schema.element())) return true;
  const auto& fields = schema.fields();
  return schema.minimum_size() > kSmall ||
         std::any_of(fields.begin(), fields.end(),
                     [](const Schema::Field& field) { return MayBeLarge(field.schema); });
}

}  // namespace

std::vector<MatchingRead> MatchingReads(const ProvidedDescription& of,
                                        const MemberDescription& command) {
  if (!TakesArgument(command.signature)) return {};
  std::vector<MatchingRead> reads;
  if (std::string whole = WholeRead(of, command); !whole.empty()) {
    reads.push_back({.name = std::move(whole), .type = command.signature.in});
  }
  if (!IsStructure(command.in_type)) return reads;
  for (const MemberDescription& one : of.commands) {
    const bool may_have_some = one.signature.kind == CommandKind::kRead &&
                               one.signature.out != command.signature.in &&
                               IsStructure(one.out_type);
    if (!may_have_some) continue;
    reads.push_back({.name = one.name, .type = one.signature.out, .is_whole = false});
  }
  return reads;
}

std::vector<std::string> CommonFields(const Schema& wanted, const Schema& offered) {
  std::vector<std::string> names;
  if (MayBeLarge(offered)) return names;
  const auto& theirs = offered.fields();
  for (const Schema::Field& field : wanted.fields()) {
    const auto same = std::find_if(theirs.begin(), theirs.end(), [&](const Schema::Field& other) {
      return other.name == field.name && other.unit == field.unit && other.schema == field.schema;
    });
    if (same != theirs.end()) names.push_back(field.name);
  }
  return names;
}

std::string WithFieldsOf(const std::string& value, const std::string& source,
                         const std::vector<std::string>& fields) {
  auto mine = nlohmann::ordered_json::parse(value, nullptr, false);
  const auto theirs = nlohmann::ordered_json::parse(source, nullptr, false);
  if (!mine.is_object() || !theirs.is_object()) return value;
  for (const std::string& field : fields) {
    if (theirs.contains(field)) mine[field] = theirs[field];
  }
  return mine.dump();
}

}  // namespace tendon
