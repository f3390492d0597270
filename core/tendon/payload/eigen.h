#pragma once

#include <tendon/payload/codec.h>
#include <tendon/payload/robot/eigen.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <vector>

/// Allows the use of Eigen types as payloads. The program must link tendon::eigen. Decoding
/// allocates only if a dynamic size changes. A default-constructed Eigen object is uninitialised.
///
///     Vector of fixed size     float64[6]
///     Matrix of fixed size     float64[cols][rows]: row after row, as on paper
///     Vector of dynamic size   float64[]
///     Matrix of dynamic size   struct tendon.MatrixFloat64: rows, cols, data row after row
///     Quaternion, Isometry     robot::Quaternion (x y z w), robot::Transform, both of float64
namespace tendon {

namespace payload {

template <int kRows, int kCols>
concept FixedVector = (kRows == 1 && kCols > 0) || (kCols == 1 && kRows > 0);
template <int kRows, int kCols>
concept FixedMatrix = kRows >
1 && kCols > 1;
template <int kRows, int kCols>
concept DynamicVector = (kRows == 1 && kCols == Eigen::Dynamic) ||
                        (kCols == 1 && kRows == Eigen::Dynamic);
template <int kRows, int kCols>
concept DynamicMatrix = (kRows == Eigen::Dynamic && kCols != 1) ||
                        (kCols == Eigen::Dynamic && kRows != 1);

template <typename Scalar, int kRows, int kCols, int kOptions>
requires FixedVector<kRows, kCols>
struct ArrayTraits<Eigen::Matrix<Scalar, kRows, kCols, kOptions>> {
  using Element = Scalar;
  static constexpr std::size_t kLength = std::size_t{kRows} * std::size_t{kCols};
};

template <typename Scalar, int kRows, int kCols, int kOptions>
requires DynamicVector<kRows, kCols>
struct SequenceTraits<Eigen::Matrix<Scalar, kRows, kCols, kOptions>> {
  using Element = Scalar;
};

template <typename Scalar, int kRows, int kCols, int kOptions>
requires FixedMatrix<kRows, kCols>
struct SubstituteFor<Eigen::Matrix<Scalar, kRows, kCols, kOptions>> {
  using Matrix = Eigen::Matrix<Scalar, kRows, kCols, kOptions>;
  using RowMajor = Eigen::Matrix<Scalar, kRows, kCols, Eigen::RowMajor>;
  using Type = std::array<std::array<Scalar, kCols>, kRows>;

  static Type From(const Matrix& matrix) {
    Type rows;
    Eigen::Map<RowMajor>(rows.front().data()) = matrix;
    return rows;
  }
  static bool Into(const Type& rows, Matrix& matrix) {
    matrix = Eigen::Map<const RowMajor>(rows.front().data());
    return true;
  }
};

/// The wire type of a matrix of dynamic size.
template <typename Scalar>
struct MatrixOnWire {
  std::uint32_t rows = 0;
  std::uint32_t cols = 0;
  std::vector<Scalar> data;
};

template <Number Scalar>
consteval std::string_view MatrixName() {
  if constexpr (std::is_floating_point_v<Scalar>) {
    return sizeof(Scalar) == 4 ? "tendon.MatrixFloat32" : "tendon.MatrixFloat64";
  } else if constexpr (std::same_as<Scalar, bool>) {
    return "tendon.MatrixBool";
  } else {
    constexpr std::array<std::string_view, 4> kSigned{"tendon.MatrixInt8", "tendon.MatrixInt16",
                                                      "tendon.MatrixInt32", "tendon.MatrixInt64"};
    constexpr std::array<std::string_view, 4> kUnsigned{
        "tendon.MatrixUint8", "tendon.MatrixUint16", "tendon.MatrixUint32", "tendon.MatrixUint64"};
    const int index = std::countr_zero(sizeof(Scalar));
    return (std::is_signed_v<Scalar> ? kSigned : kUnsigned)[index];
  }
}

template <typename Scalar, int kRows, int kCols, int kOptions>
requires DynamicMatrix<kRows, kCols>
struct SubstituteFor<Eigen::Matrix<Scalar, kRows, kCols, kOptions>> {
  using Matrix = Eigen::Matrix<Scalar, kRows, kCols, kOptions>;
  using Type = MatrixOnWire<Scalar>;

  static std::size_t EndOf(const Matrix& matrix, std::size_t start) {
    const std::size_t data = AlignUp(start, 4) + 12;
    if (matrix.size() == 0) return data;
    return AlignUp(data, sizeof(Scalar)) + static_cast<std::size_t>(matrix.size()) * sizeof(Scalar);
  }

  static void Write(CdrWriter& writer, const Matrix& matrix) {
    writer.Write(static_cast<std::uint32_t>(matrix.rows()));
    writer.Write(static_cast<std::uint32_t>(matrix.cols()));
    writer.Write(static_cast<std::uint32_t>(matrix.size()));
    if (matrix.size() == 0) return;
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
      for (Eigen::Index col = 0; col < matrix.cols(); ++col) writer.Write(matrix(row, col));
    }
  }

  static bool Read(CdrReader& reader, Matrix& matrix) {
    std::uint32_t rows = 0;
    std::uint32_t cols = 0;
    std::uint32_t size = 0;
    if (!reader.Read(rows) || !reader.Read(cols) || !reader.ReadLength(size, sizeof(Scalar))) {
      return false;
    }
    if (std::uint64_t{rows} * cols != size) return false;
    if (kRows != Eigen::Dynamic && kRows != Eigen::Index{rows}) return false;
    if (kCols != Eigen::Dynamic && kCols != Eigen::Index{cols}) return false;
    matrix.resize(rows, cols);
    if (size == 0) return true;
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
      for (Eigen::Index col = 0; col < matrix.cols(); ++col) {
        if (!reader.Read(matrix(row, col))) return false;
      }
    }
    return true;
  }
};

template <std::floating_point Scalar, int kOptions>
struct SubstituteFor<Eigen::Quaternion<Scalar, kOptions>> {
  using Quaternion = Eigen::Quaternion<Scalar, kOptions>;
  using Type = robot::Quaternion;

  static Type From(const Quaternion& quaternion) {
    return robot::ToQuaternion(quaternion.template cast<double>());
  }
  static bool Into(const Type& wire, Quaternion& quaternion) {
    quaternion = robot::ToEigen(wire).template cast<Scalar>();
    return true;
  }
};

template <std::floating_point Scalar, int kOptions>
struct SubstituteFor<Eigen::Transform<Scalar, 3, Eigen::Isometry, kOptions>> {
  using Isometry = Eigen::Transform<Scalar, 3, Eigen::Isometry, kOptions>;
  using Type = robot::Transform;

  static Type From(const Isometry& isometry) {
    return robot::ToTransform(isometry.template cast<double>());
  }
  /// Normalises the rotation; refuses a quaternion of zeros, which is no rotation.
  static bool Into(const Type& wire, Isometry& isometry) {
    if (robot::ToEigen(wire.rotation).squaredNorm() == 0) return false;
    isometry = robot::ToEigen(wire).template cast<Scalar>();
    return true;
  }
};

}  // namespace payload

template <typename Scalar>
inline constexpr auto kPayload<payload::MatrixOnWire<Scalar>> =
    Describe(payload::MatrixName<Scalar>(), Field{"rows", &payload::MatrixOnWire<Scalar>::rows},
             Field{"cols", &payload::MatrixOnWire<Scalar>::cols},
             Field{"data", &payload::MatrixOnWire<Scalar>::data});

}  // namespace tendon
