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

/// An uncompressed picture from a payload, row by row from the top: a robot::Image, or any
/// structure with `width`, `height`, `data`, and `encoding` or `channels`. These values are not
/// checked yet; Draw() does that.
struct RawImage {
  std::uint64_t width = 0;   ///< pixels
  std::uint64_t height = 0;  ///< rows
  std::uint64_t step = 0;    ///< bytes per row; 0: as many as its pixels need
  QString encoding;          ///< "rgb8", "mono16", ...
  bool is_bigendian = false;
  QByteArray data;
};

/// Larger pictures are not drawn.
inline constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 25U;

/// True if values of this type are pictures.
[[nodiscard]] bool DescribesImage(const Schema& schema);
/// The picture in a value of such a type; empty if the bytes are not such a value.
[[nodiscard]] std::optional<RawImage> RawImageOf(const Schema& schema,
                                                 std::span<const std::byte> body);

/// True if the start of an answer looks like a picture. Constant time.
[[nodiscard]] bool LooksLikeImage(const std::string& json);
/// Empty if it is not a picture. Takes a second for about ten million pixels.
[[nodiscard]] std::optional<RawImage> RawImageOf(const std::string& json);

/// Converts to an image. The error, kInvalid, says which sizes do not match, or which value is
/// unknown. Any thread.
[[nodiscard]] Result<QImage> Draw(const RawImage& picture);

}  // namespace tendon::gui
