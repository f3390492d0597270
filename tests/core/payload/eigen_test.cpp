#include <gtest/gtest.h>
#include <support/encoded.h>
#include <tendon/payload/eigen.h>
#include <tendon/payload/json.h>
#include <tendon/payload/schema.h>

namespace arm {
struct Model {
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Eigen::VectorXd torque;
  Eigen::MatrixXd jacobian;
  Eigen::Isometry3d tool = Eigen::Isometry3d::Identity();
};
}  // namespace arm

template <>
inline constexpr auto tendon::kPayload<arm::Model> = tendon::Describe(
    "arm.Model", tendon::Field{"gravity", &arm::Model::gravity, "m/s^2"},
    tendon::Field{"inertia", &arm::Model::inertia},
    tendon::Field{"torque", &arm::Model::torque, "N m"},
    tendon::Field{"jacobian", &arm::Model::jacobian}, tendon::Field{"tool", &arm::Model::tool});

namespace tendon {
namespace {

using test::Encoded;

TEST(Eigen, DefinesWhichPayloadsHaveAFixedSize) {
  static_assert(FixedPayload<Eigen::Vector3d> && FixedPayload<Eigen::Matrix<float, 6, 7>>);
  static_assert(FixedPayload<Eigen::Quaterniond> && FixedPayload<Eigen::Isometry3d>);
  static_assert(Payload<Eigen::VectorXd> && Payload<Eigen::MatrixXf>);
  static_assert(!FixedPayload<Eigen::VectorXd> && !FixedPayload<Eigen::MatrixXd>);
  static_assert(kEncodedSize<Eigen::Isometry3d> == 56);
}

TEST(Eigen, HasTheSchemaOfItsShape) {
  EXPECT_EQ(SchemaOf<Eigen::Vector3d>().TypeName(), "float64[3]");
  EXPECT_EQ((SchemaOf<Eigen::Matrix<double, 2, 3>>().TypeName()), "float64[3][2]");
  EXPECT_EQ(SchemaOf<Eigen::VectorXf>().TypeName(), "float32[]");
  EXPECT_EQ(SchemaOf<Eigen::MatrixXd>().TypeName(), "tendon.MatrixFloat64");
  EXPECT_EQ(SchemaOf<Eigen::Isometry3d>().TypeName(), "geometry_msgs.Transform");
}

TEST(Eigen, AMatrixIsEncodedRowByRow) {
  Eigen::Matrix<double, 2, 3> matrix;
  matrix << 1, 2, 3, 4, 5, 6;

  EXPECT_EQ(ToJson(matrix), "[[1,2,3],[4,5,6]]");
  EXPECT_EQ(ToJson(Eigen::MatrixXd(matrix)), R"({"rows":2,"cols":3,"data":[1,2,3,4,5,6]})");
}

TEST(Eigen, AQuaternionIsEncodedAsXyzw) {
  EXPECT_EQ(ToJson(Eigen::Quaterniond(1, 2, 3, 4)), R"({"x":2,"y":3,"z":4,"w":1})");
}

TEST(Eigen, EveryTypeRoundTrips) {
  arm::Model model;
  model.gravity = {0, 0, -9.81};
  model.inertia << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  model.torque = Eigen::VectorXd::LinSpaced(5, 0, 1);
  model.jacobian = Eigen::MatrixXd::Random(6, 7);
  model.tool =
      Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized());
  const auto body = Encoded(model);
  arm::Model decoded;

  ASSERT_TRUE(Decode(body, decoded));

  EXPECT_EQ(body.size(), EncodedSize(model));
  EXPECT_EQ(decoded.gravity, model.gravity);
  EXPECT_EQ(decoded.inertia, model.inertia);
  EXPECT_EQ(decoded.torque, model.torque);
  EXPECT_EQ(decoded.jacobian, model.jacobian);
  EXPECT_TRUE(decoded.tool.isApprox(model.tool, 1e-12));
}

TEST(Eigen, MatricesAreWrittenAsTheirSchemaDefines) {
  arm::Model model;
  model.torque.setOnes(2);
  model.jacobian.setIdentity(2, 2);

  const auto json = ToJson(model);
  const auto back = FromJson<arm::Model>(json);

  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(ToJson(*back), json);
}

TEST(Eigen, RefusesAMatrixWithAContradictoryShape) {
  using Wire = payload::MatrixOnWire<double>;
  Eigen::MatrixXd matrix;
  Eigen::Matrix<double, Eigen::Dynamic, 3> three_wide;

  EXPECT_TRUE(Decode(Encoded(Wire{1, 2, {1, 2}}), matrix));
  EXPECT_FALSE(Decode(Encoded(Wire{2, 2, {1, 2}}), matrix));
  EXPECT_FALSE(Decode(Encoded(Wire{0x80000000, 0x80000000, {}}), matrix));
  EXPECT_TRUE(Decode(Encoded(Wire{0xffffffff, 0, {}}), matrix));
  EXPECT_FALSE(Decode(Encoded(Wire{1, 2, {1, 2}}), three_wide));
  EXPECT_TRUE(Decode(Encoded(Wire{1, 3, {1, 2, 3}}), three_wide));
}

TEST(Eigen, RefusesAMatrixTruncatedAtAnyByte) {
  const auto body = Encoded(Eigen::MatrixXd(Eigen::MatrixXd::Random(2, 3)));
  for (std::size_t size = 0; size < body.size(); ++size) {
    Eigen::MatrixXd matrix;
    EXPECT_FALSE(Decode(std::span(body).first(size), matrix)) << size;
  }
}

TEST(Eigen, RotationsInFloatConnectToThoseInDouble) {
  const Eigen::Quaternionf rotation(0.5F, -0.5F, 0.5F, -0.5F);
  const Eigen::Isometry3f place = Eigen::Translation3f(1, -2, 3) * rotation;
  Eigen::Quaterniond rotation_in_double;
  Eigen::Isometry3d place_in_double;
  Eigen::Isometry3f place_again;

  ASSERT_TRUE(Decode(Encoded(rotation), rotation_in_double));
  ASSERT_TRUE(Decode(Encoded(place), place_in_double));
  ASSERT_TRUE(Decode(Encoded(place_in_double), place_again));

  EXPECT_EQ(SchemaOf<Eigen::Quaternionf>(), SchemaOf<Eigen::Quaterniond>());
  EXPECT_EQ(SchemaOf<Eigen::Isometry3f>(), SchemaOf<Eigen::Isometry3d>());
  EXPECT_EQ(rotation_in_double.coeffs(), rotation.cast<double>().coeffs());
  EXPECT_TRUE(place_in_double.isApprox(place.cast<double>(), 1e-6));
  EXPECT_TRUE(place_again.isApprox(place, 1e-6F));
}

TEST(Eigen, ARotationOfZerosIsRefused) {
  Eigen::Isometry3d isometry;
  EXPECT_FALSE(Decode(Encoded(std::array<double, 7>{}), isometry));
}

}  // namespace
}  // namespace tendon
