#include <gcm_gui/views/raw_image.h>

#include <gcm_gui/language/words.h>
#include <tendon/payload/cdr.h>

#include <QtEndian>
#include <algorithm>
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>

namespace tendon::gui {
namespace {

using Kind = Schema::Kind;
using payload::CdrReader;

// The number of bytes at the beginning of a result that are examined; pixels come last.
constexpr std::size_t kHead = 4096;

struct Encoding {
  const char* name;
  QImage::Format format;
  std::uint64_t bytes;  // bytes of a pixel
};
constexpr std::array kEncodings{Encoding{"rgb8", QImage::Format_RGB888, 3},
                                Encoding{"bgr8", QImage::Format_BGR888, 3},
                                Encoding{"8UC3", QImage::Format_BGR888, 3},
                                Encoding{"rgba8", QImage::Format_RGBA8888, 4},
                                Encoding{"bgra8", QImage::Format_ARGB32, 4},
                                Encoding{"mono8", QImage::Format_Grayscale8, 1},
                                Encoding{"8UC1", QImage::Format_Grayscale8, 1},
                                Encoding{"mono16", QImage::Format_Grayscale16, 2},
                                Encoding{"16UC1", QImage::Format_Grayscale16, 2}};

/// Returns the encoding of a structure that has `channels` instead of `encoding`.
QString EncodingOfChannels(std::uint64_t channels) {
  if (channels == 1) return QStringLiteral("mono8");
  if (channels == 3) return QStringLiteral("rgb8");
  if (channels == 4) return QStringLiteral("rgba8");
  return Words::tr("%1 channels").arg(channels);
}

bool IsByteList(const Schema& schema) {
  const bool is_list = schema.kind() == Kind::kSequence || schema.kind() == Kind::kArray;
  return is_list && schema.element().kind() == Kind::kUint8;
}

bool IsInteger(const Schema& schema) { return schema.kind() <= Kind::kUint64; }

template <typename T>
bool ReadAs(CdrReader& reader, std::uint64_t& value) {
  T number{};
  if (!reader.Read(number) || number < T{0}) return false;
  value = static_cast<std::uint64_t>(number);
  return true;
}

bool ReadInteger(Kind kind, CdrReader& reader, std::uint64_t& value) {
  switch (kind) {
    case Kind::kBool:
    case Kind::kUint8:
      return ReadAs<std::uint8_t>(reader, value);
    case Kind::kInt8:
      return ReadAs<std::int8_t>(reader, value);
    case Kind::kInt16:
      return ReadAs<std::int16_t>(reader, value);
    case Kind::kUint16:
      return ReadAs<std::uint16_t>(reader, value);
    case Kind::kInt32:
      return ReadAs<std::int32_t>(reader, value);
    case Kind::kUint32:
      return ReadAs<std::uint32_t>(reader, value);
    case Kind::kInt64:
      return ReadAs<std::int64_t>(reader, value);
    default:
      return ReadAs<std::uint64_t>(reader, value);
  }
}

bool ReadBytes(const Schema& list, CdrReader& reader, QByteArray& bytes) {
  std::uint32_t count = list.kind() == Kind::kArray ? list.length() : 0;
  if (list.kind() == Kind::kSequence && !reader.ReadLength(count, 1)) return false;
  if (count > reader.remaining()) return false;
  bytes.resize(static_cast<qsizetype>(count));
  return reader.ReadPlain(bytes.data(), count, 1);
}

/// Skips one value; returns false if there are too few bytes.
bool SkipOver(const Schema& schema, CdrReader& reader) {
  switch (schema.kind()) {
    case Kind::kString: {
      std::string_view text;
      return reader.ReadString(text);
    }
    case Kind::kDuration:
      return reader.Skip(8, 4);
    case Kind::kArray:
    case Kind::kSequence: {
      std::uint32_t count = schema.kind() == Kind::kArray ? schema.length() : 0;
      if (schema.kind() == Kind::kSequence &&
          !reader.ReadLength(count, schema.element().minimum_size())) {
        return false;
      }
      for (; count > 0; --count) {
        if (!SkipOver(schema.element(), reader)) return false;
      }
      return true;
    }
    case Kind::kStructure:
      if (schema.is_none()) return reader.Skip(1, 1);
      return std::all_of(schema.fields().begin(), schema.fields().end(),
                         [&](const auto& field) { return SkipOver(field.schema, reader); });
    default:
      return reader.Skip(schema.minimum_size(), schema.minimum_size());
  }
}

bool ReadField(const Schema::Field& field, CdrReader& reader, RawImage& picture) {
  const bool is_integer = IsInteger(field.schema);
  std::uint64_t number = 0;
  if (is_integer && !ReadInteger(field.schema.kind(), reader, number)) return false;
  if (field.name == "width") picture.width = number;
  if (field.name == "height") picture.height = number;
  if (field.name == "step") picture.step = number;
  if (field.name == "is_bigendian") picture.is_bigendian = number != 0;
  if (field.name == "channels") picture.encoding = EncodingOfChannels(number);
  if (is_integer) return true;
  if (field.name == "data") return ReadBytes(field.schema, reader, picture.data);
  if (field.name == "encoding" && field.schema.kind() == Kind::kString) {
    std::string_view text;
    if (!reader.ReadString(text)) return false;
    picture.encoding = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    return true;
  }
  return SkipOver(field.schema, reader);
}

std::uint64_t UnsignedIn(const nlohmann::json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_number_unsigned() ? found->get<std::uint64_t>() : 0;
}

std::optional<QByteArray> BytesIn(const nlohmann::json& list) {
  QByteArray bytes(static_cast<qsizetype>(list.size()), '\0');
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!list[i].is_number_unsigned() || list[i].get<std::uint64_t>() > 255) return std::nullopt;
    bytes[static_cast<qsizetype>(i)] = static_cast<char>(list[i].get<std::uint8_t>());
  }
  return bytes;
}

Error Wrong(const QString& what) { return {ErrorCode::kInvalid, what.toStdString()}; }

/// Converts pixels of several bytes to the byte order of this machine.
void TurnBytes(QImage& image, bool is_bigendian) {
  if (image.format() != QImage::Format_Grayscale16) return;
  for (int row = 0; row < image.height(); ++row) {
    auto* pixels = reinterpret_cast<quint16*>(image.scanLine(row));
    for (int column = 0; column < image.width(); ++column) {
      pixels[column] =
          is_bigendian ? qFromBigEndian(pixels[column]) : qFromLittleEndian(pixels[column]);
    }
  }
}

}  // namespace

bool DescribesImage(const Schema& schema) {
  if (schema.kind() != Kind::kStructure) return false;
  const auto has = [&](const char* name, auto fits) {
    return std::any_of(schema.fields().begin(), schema.fields().end(),
                       [&](const auto& field) { return field.name == name && fits(field.schema); });
  };
  const auto is_text = [](const Schema& field) { return field.kind() == Kind::kString; };
  return has("width", IsInteger) && has("height", IsInteger) && has("data", IsByteList) &&
         (has("encoding", is_text) || has("channels", IsInteger));
}

std::optional<RawImage> RawImageOf(const Schema& schema, std::span<const std::byte> body) {
  CdrReader reader(body);
  RawImage picture;
  for (const Schema::Field& field : schema.fields()) {
    if (!ReadField(field, reader, picture)) return std::nullopt;
  }
  return picture;
}

bool LooksLikeImage(const std::string& json) {
  const std::string_view head = std::string_view(json).substr(0, kHead);
  const auto has = [head](std::string_view key) { return head.find(key) != head.npos; };
  return has("\"width\"") && has("\"height\"") && has("\"data\"") &&
         (has("\"encoding\"") || has("\"channels\""));
}

std::optional<RawImage> RawImageOf(const std::string& json) {
  const nlohmann::json result = nlohmann::json::parse(json, nullptr, false);
  if (!result.is_object() || !result.contains("data") || !result["data"].is_array()) {
    return std::nullopt;
  }
  auto data = BytesIn(result["data"]);
  if (!data) return std::nullopt;
  RawImage picture{.width = UnsignedIn(result, "width"),
                   .height = UnsignedIn(result, "height"),
                   .step = UnsignedIn(result, "step"),
                   .encoding = EncodingOfChannels(UnsignedIn(result, "channels")),
                   .is_bigendian = UnsignedIn(result, "is_bigendian") != 0,
                   .data = *std::move(data)};
  if (const auto encoding = result.find("encoding"); encoding != result.end()) {
    if (!encoding->is_string()) return std::nullopt;
    picture.encoding = QString::fromStdString(encoding->get<std::string>());
  }
  return picture;
}

Result<QImage> Draw(const RawImage& picture) {
  const auto known = std::find_if(kEncodings.begin(), kEncodings.end(), [&](const auto& one) {
    return picture.encoding == QLatin1String(one.name);
  });
  if (known == kEncodings.end()) {
    QStringList names;
    for (const Encoding& one : kEncodings) names.append(QLatin1String(one.name));
    return Wrong(Words::tr("a picture with encoding '%1' cannot be drawn; supported encodings: %2")
                     .arg(picture.encoding.left(32), names.join(QStringLiteral(", "))));
  }
  const auto size = QStringLiteral("%1 × %2").arg(picture.width).arg(picture.height);
  if (picture.width == 0 || picture.height == 0) {
    return Wrong(
        Words::tr("a picture of %1 pixels is empty: width and height must be above 0").arg(size));
  }
  if (picture.width > kMaxPixels || picture.height > kMaxPixels / picture.width) {
    return Wrong(Words::tr("a picture of %1 pixels is too large to be drawn: at most %2")
                     .arg(size)
                     .arg(kMaxPixels));
  }
  const std::uint64_t row = picture.width * known->bytes;
  const std::uint64_t step = picture.step == 0 ? row : picture.step;
  if (step < row) {
    return Wrong(Words::tr("a row of %1 pixels in %2 needs %3 bytes, but the field step is %4")
                     .arg(picture.width)
                     .arg(picture.encoding)
                     .arg(row)
                     .arg(step));
  }
  const auto there = static_cast<std::uint64_t>(picture.data.size());
  if (there / step < picture.height || there != picture.height * step) {
    return Wrong(Words::tr("%1 rows of %2 bytes do not match the %3 bytes of data")
                     .arg(picture.height)
                     .arg(step)
                     .arg(there));
  }
  QImage image(static_cast<int>(picture.width), static_cast<int>(picture.height), known->format);
  for (int line = 0; line < image.height(); ++line) {
    std::memcpy(image.scanLine(line),
                picture.data.constData() + static_cast<qsizetype>(step) * line, row);
  }
  TurnBytes(image, picture.is_bigendian);
  return image;
}

}  // namespace tendon::gui
