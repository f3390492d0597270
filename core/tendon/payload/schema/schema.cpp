#include <tendon/payload/fingerprint.h>
#include <tendon/payload/schema.h>

#include <array>
#include <cassert>
#include <utility>

namespace tendon {

struct Schema::Node {
  Kind kind = Kind::kStructure;
  std::string name;
  std::vector<Field> fields;
  std::vector<Enumerator> enumerators;
  std::optional<Schema> element;
  std::uint32_t length = 0;
  std::size_t minimum_size = 1;
};

namespace {

std::size_t SimpleSize(Schema::Kind kind) {
  switch (kind) {
    case Schema::Kind::kBool:
    case Schema::Kind::kInt8:
    case Schema::Kind::kUint8:
      return 1;
    case Schema::Kind::kInt16:
    case Schema::Kind::kUint16:
      return 2;
    case Schema::Kind::kInt32:
    case Schema::Kind::kUint32:
    case Schema::Kind::kFloat32:
    case Schema::Kind::kEnum:
    case Schema::Kind::kSequence:
      return 4;
    case Schema::Kind::kString:
      return 5;
    case Schema::Kind::kInt64:
    case Schema::Kind::kUint64:
    case Schema::Kind::kFloat64:
    case Schema::Kind::kDuration:
      return 8;
    case Schema::Kind::kArray:
    case Schema::Kind::kStructure:
      break;
  }
  return 1;
}

}  // namespace

Schema::Schema() : Schema(SchemaOf<None>()) {}

Schema::Schema(std::shared_ptr<const Node> node) : node_(std::move(node)) {}

Schema::Schema(Kind simple) {
  assert(simple <= Kind::kDuration);
  Node node;
  node.kind = simple;
  node.minimum_size = SimpleSize(simple);
  node_ = std::make_shared<const Node>(std::move(node));
}

Schema Schema::Enum(std::string name, std::vector<Enumerator> enumerators) {
  Node node;
  node.kind = Kind::kEnum;
  node.name = std::move(name);
  node.enumerators = std::move(enumerators);
  node.minimum_size = SimpleSize(Kind::kEnum);
  return Schema(std::make_shared<const Node>(std::move(node)));
}

Schema Schema::Array(Schema element, std::uint32_t length) {
  Node node;
  node.kind = Kind::kArray;
  node.length = length;
  node.minimum_size = length * element.minimum_size();
  node.element = std::move(element);
  return Schema(std::make_shared<const Node>(std::move(node)));
}

Schema Schema::Sequence(Schema element) {
  Node node;
  node.kind = Kind::kSequence;
  node.minimum_size = SimpleSize(Kind::kSequence);
  node.element = std::move(element);
  return Schema(std::make_shared<const Node>(std::move(node)));
}

Schema Schema::Structure(std::string name, std::vector<Field> fields) {
  Node node;
  node.name = std::move(name);
  node.fields = std::move(fields);
  if (!node.fields.empty()) {
    node.minimum_size = 0;
    for (const Field& field : node.fields) node.minimum_size += field.schema.minimum_size();
  }
  return Schema(std::make_shared<const Node>(std::move(node)));
}

Schema::Kind Schema::kind() const { return node_->kind; }
const std::string& Schema::name() const { return node_->name; }
const std::vector<Schema::Field>& Schema::fields() const { return node_->fields; }
const std::vector<Schema::Enumerator>& Schema::enumerators() const { return node_->enumerators; }
std::uint32_t Schema::length() const { return node_->length; }
std::size_t Schema::minimum_size() const { return node_->minimum_size; }

const Schema& Schema::element() const {
  assert(node_->element);
  return *node_->element;
}

Fingerprint Schema::fingerprint() const { return FingerprintOf(Text()); }

bool Schema::operator==(const Schema& other) const {
  return node_ == other.node_ || Text() == other.Text();
}

bool Schema::holds_numbers() const {
  switch (kind()) {
    case Kind::kArray:
    case Kind::kSequence:
      return element().holds_numbers();
    default:
      return kind() == Kind::kDuration || (is_number() && kind() != Kind::kBool);
  }
}

std::string Schema::TypeName() const {
  switch (kind()) {
    case Kind::kArray:
      return element().TypeName() + "[" + std::to_string(length()) + "]";
    case Kind::kSequence:
      return element().TypeName() + "[]";
    case Kind::kEnum:
    case Kind::kStructure:
      return name();
    default:
      return std::string(ToString(kind()));
  }
}

std::string_view ToString(Schema::Kind kind) {
  constexpr std::array<std::string_view, 17> kNames{
      "bool",    "int8",    "uint8",  "int16",    "uint16", "int32", "uint32",   "int64", "uint64",
      "float32", "float64", "string", "duration", "enum",   "array", "sequence", "struct"};
  return kNames.at(static_cast<std::size_t>(kind));
}

}  // namespace tendon
