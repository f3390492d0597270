#include <gtest/gtest.h>
#include <tendon/payload/eigen.h>
#include <tendon/payload/schema.h>
#include <tendon/payload/time_point.h>

#include "core/payload/fast_cdr.h"

/// Compares types that are encoded as another type with Fast CDR. A byte before each value tests
/// the alignment.
namespace tendon {
namespace {

using eprosima::fastcdr::Cdr;

template <typename T>
struct AfterAByte {
  std::uint8_t byte = 7;
  T value;
};

template <typename Writer>
std::vector<std::byte> WrittenByFastCdr(Writer write) {
  return test::WrittenByFastCdr([&](Cdr& cdr) {
    cdr << std::uint8_t{7};
    write(cdr);
  });
}

}  // namespace

template <typename T>
inline constexpr auto kPayload<AfterAByte<T>> = Describe("sample.AfterAByte",
                                                         Field{"byte", &AfterAByte<T>::byte},
                                                         Field{"value", &AfterAByte<T>::value});

namespace {

template <typename T>
std::vector<std::byte> Written(const T& value) {
  std::vector<std::byte> body;
  Encode(AfterAByte<T>{7, value}, body);
  return body;
}

TEST(EigenFastCdr, AVectorOfFixedSizeIsAnArray) {
  EXPECT_EQ(Written(Eigen::Vector3d(1, 2, 3)), WrittenByFastCdr([](Cdr& cdr) {
              cdr << std::array<double, 3>{1, 2, 3};
            }));
}

TEST(EigenFastCdr, AMatrixOfFixedSizeIsAnArrayRowAfterRow) {
  Eigen::Matrix<float, 2, 3> matrix;
  matrix << 1, 2, 3, 4, 5, 6;

  EXPECT_EQ(Written(matrix),
            WrittenByFastCdr([](Cdr& cdr) { cdr << std::array<float, 6>{1, 2, 3, 4, 5, 6}; }));
}

TEST(EigenFastCdr, AVectorOfDynamicSizeIsASequence) {
  Eigen::VectorXd vector(3);
  vector << 1, 2, 3;

  EXPECT_EQ(Written(vector), WrittenByFastCdr([](Cdr& cdr) {
              cdr << std::vector<double>{1, 2, 3};
            }));
  EXPECT_EQ(Written(Eigen::VectorXd()),
            WrittenByFastCdr([](Cdr& cdr) { cdr << std::vector<double>{}; }));
}

TEST(EigenFastCdr, AMatrixOfDynamicSizeHasItsShapeBeforeIt) {
  Eigen::Matrix<std::int16_t, Eigen::Dynamic, Eigen::Dynamic> matrix(2, 2);
  matrix << 1, -2, 3, -4;

  EXPECT_EQ(
      Written(matrix), WrittenByFastCdr([](Cdr& cdr) {
        cdr << std::uint32_t{2} << std::uint32_t{2} << std::vector<std::int16_t>{1, -2, 3, -4};
      }));
  EXPECT_EQ(SchemaOf<decltype(matrix)>().TypeName(), "tendon.MatrixInt16");
}

TEST(EigenFastCdr, AQuaternionIsXyzw) {
  EXPECT_EQ(Written(Eigen::Quaterniond(1, 2, 3, 4)),
            WrittenByFastCdr([](Cdr& cdr) { cdr << 2.0 << 3.0 << 4.0 << 1.0; }));
}

TEST(EigenFastCdr, AnIsometryIsATransform) {
  const Eigen::Isometry3d isometry(Eigen::Translation3d(1, 2, 3));

  EXPECT_EQ(Written(isometry), WrittenByFastCdr([](Cdr& cdr) {
              cdr << 1.0 << 2.0 << 3.0 << 0.0 << 0.0 << 0.0 << 1.0;
            }));
}

TEST(EigenFastCdr, ATimePointIsTwoNumbers) {
  const std::chrono::sys_time<std::chrono::milliseconds> time(std::chrono::milliseconds(-1));

  EXPECT_EQ(Written(time), WrittenByFastCdr([](Cdr& cdr) {
              cdr << std::int32_t{-1} << std::uint32_t{999'000'000};
            }));
}

TEST(EigenFastCdr, AMatrixOfBoolsIsCheckedOnDecoding) {
  using Matrix = Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic>;
  auto body = Written(Matrix(Matrix::Constant(1, 3, true)));
  AfterAByte<Matrix> decoded;
  EXPECT_TRUE(Decode(body, decoded));
  EXPECT_EQ(decoded.value, Matrix::Constant(1, 3, true));

  body.back() = std::byte{2};

  EXPECT_FALSE(Decode(body, decoded));
}

}  // namespace
}  // namespace tendon
