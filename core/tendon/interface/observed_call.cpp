#include <tendon/interface/observed_call.h>

#include <algorithm>
#include <utility>

namespace tendon {
namespace {

using namespace std::chrono_literals;

constexpr const char* kArgument = "argument";
constexpr const char* kResult = "result";

static_assert(kEncodedSize<CallHeader> % payload::kMaxAlignment == 0);

Schema FieldOf(const Schema& calls, const char* name) {
  const auto field = std::ranges::find(calls.fields(), name, &Schema::Field::name);
  return field == calls.fields().end() ? Schema() : field->schema;
}

}  // namespace

MemberDescription DescribeCalls(MemberDescription command) {
  command.signature.kind = CommandKind::kWrite;
  command.optional = false;
  command.hazard.clear();
  command.expires_after = 0.0;
  return command;
}

Schema SchemaOfCalls(const Schema& argument, const Schema& result) {
  std::vector<Schema::Field> fields = SchemaOf<CallHeader>().fields();
  if (!argument.is_none()) fields.push_back({kArgument, "", argument});
  if (!result.is_none()) fields.push_back({kResult, "", result});
  fields.push_back({"client", "", Schema(Schema::Kind::kString)});
  const std::string& type = argument.is_none() ? result.name() : argument.name();
  const bool is_named = !type.empty() && !(argument.is_none() && result.is_none());
  return Schema::Structure(is_named ? type + "Call" : "tendon.Call", std::move(fields));
}

Schema ArgumentOfCalls(const Schema& calls) { return FieldOf(calls, kArgument); }
Schema ResultOfCalls(const Schema& calls) { return FieldOf(calls, kResult); }

CallHeader HeaderOfCall(std::span<const std::byte> call) {
  CallHeader header;
  const auto bytes = call.first(std::min(call.size(), kEncodedSize<CallHeader>));
  if (!Decode(bytes, header)) return {};
  header.took = std::clamp<std::chrono::nanoseconds>(header.took, 0ns, 24h);
  return header;
}

}  // namespace tendon
