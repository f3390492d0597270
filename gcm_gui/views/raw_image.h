#pragma once

#include <tendon/base/result.h>
#include <tendon/payload/schema.h>

#include <QByteArray>
#include <QImage>
#include <QString>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace tendon::gui {

/// An uncompressed picture in a payload, row by row from the top. The payload is a robot::Image, or
/// any structure with the fields `width`, `height`, `data`, and `encoding` or `channels`. The
/// values are not checked yet; Draw() checks them.
struct RawImage {
  std::uint64_t width = 0;   ///< pixels
  std::uint64_t height = 0;  ///< rows
  std::uint64_t step = 0;    ///< bytes per row; 0: computed from the width
  QString encoding;          ///< "rgb8", "mono16", ...
  bool is_bigendian = false;
  QByteArray data;
};

/// Larger pictures are not drawn.
inline constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 25U;

/// Returns true if values of this type are pictures.
[[nodiscard]] bool DescribesImage(const Schema& schema);
/// Returns the picture in a value of a type that DescribesImage(); empty if the bytes are not a
/// value of this type.
[[nodiscard]] std::optional<RawImage> RawImageOf(const Schema& schema,
                                                 std::span<const std::byte> body);

/// Returns true if the beginning of a result looks like a picture. O(1).
[[nodiscard]] bool LooksLikeImage(const std::string& json);
/// Returns the picture in a result; empty if it is not a picture. Takes about a second for ten
/// million pixels.
[[nodiscard]] std::optional<RawImage> RawImageOf(const std::string& json);

/// Converts a picture to an image. The error kInvalid says which values do not match, or which
/// value is unknown. Any thread.
[[nodiscard]] Result<QImage> Draw(const RawImage& picture);

}  // namespace tendon::gui
