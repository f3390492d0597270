#include "typed_decode.h"

#include <support/encoded.h>
#include <tendon/middleware/body.h>
#include <tendon/middleware/handshake.h>
#include <tendon/payload/eigen.h>
#include <tendon/payload/json.h>
#include <tendon/payload/robot/image.h>
#include <tendon/payload/robot/joints.h>
#include <tendon/payload/robot/joystick.h>
#include <tendon/payload/robot/transforms.h>
#include <tests/core/payload/sample_types.h>

#include <array>

#include "promise.h"

namespace fuzz {
namespace {

using tendon::test::Encoded;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;

template <typename T>
void Decode(Bytes bytes) {
  // A separate copy, so that a sanitizer detects reads beyond its end.
  const std::vector<std::byte> body(bytes.begin(), bytes.end());
  T value{};
  if (!tendon::Decode(body, value)) return;
  const auto again = Encoded(value);
  Require(again.size() <= body.size() && body.size() - again.size() < 8,
          "what decodes encodes to as many bytes");
  T twin{};
  Require(tendon::Decode(again, twin), "what was encoded decodes");
  Require(Encoded(twin) == again, "what was encoded decodes to itself");
  Require(tendon::ToJson(tendon::SchemaOf<T>(), body).ok(),
          "what decodes by its type decodes by its schema");
}

template <typename T>
void Read(Bytes bytes) {
  const auto body = tendon::FromJson(tendon::SchemaOf<T>(), TextOf(bytes));
  if (!body) {
    Require(!body.error().message.empty(), "a refusal has a reason");
    return;
  }
  const auto json = tendon::ToJson(tendon::SchemaOf<T>(), *body);
  Require(json.ok(), "what was read prints");
  Require(tendon::FromJson(tendon::SchemaOf<T>(), *json).ok(), "what was printed reads back");
  const auto value = tendon::FromJson<T>(TextOf(bytes));
  Require(!value || tendon::ToJson(*value) == *json, "type and schema print the same");
}

}  // namespace

void DecodeTyped(Bytes bytes) {
  constexpr std::array kDecoders{Decode<sample::Dynamic>,
                                 Decode<sample::Fixed>,
                                 Decode<sample::Numbers>,
                                 Decode<Eigen::MatrixXd>,
                                 Decode<Rows>,
                                 Decode<Eigen::Matrix3f>,
                                 Decode<Eigen::VectorXf>,
                                 Decode<tendon::message::Challenge>,
                                 Decode<tendon::Error>,
                                 Decode<std::vector<sample::JointState>>,
                                 Decode<tendon::robot::Image>,
                                 Decode<tendon::robot::NamedJointState>,
                                 Decode<tendon::robot::Transforms>};
  const std::size_t choice = TakeChoice(bytes, kDecoders.size());
  kDecoders.at(choice)(bytes);
}

void ReadJson(Bytes bytes) {
  constexpr std::array kReaders{
      Read<sample::Dynamic>,        Read<sample::Fixed>, Read<sample::Numbers>,
      Read<tendon::None>,           Read<Rows>,          Read<tendon::message::Greeting>,
      Read<tendon::robot::Joystick>};
  const std::size_t choice = TakeChoice(bytes, kReaders.size());
  kReaders.at(choice)(bytes);
}

}  // namespace fuzz
