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

/// An uncompressed picture as a payload holds it, row after row from the top: what robot::Image
/// describes, and any structure with `width`, `height`, `data`, and `encoding` or `channels`. What
/// it says of itself need not be true; Draw() looks.
struct RawPicture {
  std::uint64_t width = 0;   ///< pixels
  std::uint64_t height = 0;  ///< rows
  std::uint64_t step = 0;    ///< bytes of a row; 0: as many as its pixels take
  QString encoding;          ///< "rgb8", "mono16", ...
  bool is_bigendian = false;
  QByteArray data;
};

/// Most pixels of a picture that is drawn.
inline constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 25U;

/// Whether values of this type are pictures.
[[nodiscard]] bool DescribesPicture(const Schema& schema);
/// Of a value whose type describes a picture; nothing where the bytes are no such value.
[[nodiscard]] std::optional<RawPicture> PictureOf(const Schema& schema,
                                                  std::span<const std::byte> body);

/// Whether the beginning of an answer looks like that of a picture; costs the same for any length.
[[nodiscard]] bool LooksLikePicture(const std::string& json);
/// Nothing where it is no picture after all. Takes a second for some ten million pixels.
[[nodiscard]] std::optional<RawPicture> PictureOf(const std::string& json);

/// What can be drawn; kInvalid says which sizes do not fit, or what is not known. Any thread.
[[nodiscard]] Result<QImage> Draw(const RawPicture& picture);

}  // namespace tendon::gui
