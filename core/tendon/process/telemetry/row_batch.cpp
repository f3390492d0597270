#include <tendon/process/telemetry/row_batch.h>

#include <tendon/payload/codec.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <span>

namespace tendon {
namespace {

/// The offset of the body in the memory of a writer. The space before the body is for the frame's
/// header.
constexpr std::size_t kBody = FrameHeader::kSize;
constexpr std::size_t kHeaderSize = 32;
constexpr std::size_t kStampSize = 16;  // tick and time
constexpr std::size_t kReferenceSize = 8;

static_assert(kEncodedSize<message::RowsHeader> == kHeaderSize);

constexpr std::size_t Padded(std::size_t size) { return payload::AlignUp(size, 8); }

/// Returns the number of bytes that a cell occupies in its row.
constexpr std::size_t PlaceSize(std::uint32_t size) {
  return size != 0 ? Padded(size) : kReferenceSize;
}

}  // namespace

RowBatchWriter::RowBatchWriter(std::vector<std::uint32_t> sizes)
    : sizes_(std::move(sizes)),
      first_row_(kBody + Padded(kHeaderSize + sizes_.size() * sizeof(std::uint32_t))),
      row_size_(kStampSize) {
  for (const std::uint32_t size : sizes_) row_size_ += PlaceSize(size);
  frame_.resize(first_row_);
  std::ranges::copy(std::as_bytes(std::span(sizes_)), frame_.begin() + kBody + kHeaderSize);
}

void RowBatchWriter::Clear() {
  frame_.resize(first_row_);
  loose_.clear();
  rows_ = 0;
  is_joined_ = false;
}

void RowBatchWriter::BeginRow(std::uint64_t tick, std::int64_t time) {
  position_ = frame_.size();
  frame_.resize(position_ + row_size_);  // filled with zeroes
  std::memcpy(frame_.data() + position_, &tick, sizeof tick);
  std::memcpy(frame_.data() + position_ + sizeof tick, &time, sizeof time);
  position_ += kStampSize;
  column_ = 0;
  ++rows_;
}

void RowBatchWriter::AddCell(std::span<const std::byte> cell) {
  const std::uint32_t size = sizes_[column_++];
  std::byte* place = frame_.data() + position_;
  position_ += PlaceSize(size);
  if (size != 0) {
    assert(cell.size() == size);
    std::memcpy(place, cell.data(), size);
    return;
  }
  const auto offset = static_cast<std::uint32_t>(loose_.size());
  const auto bytes = static_cast<std::uint32_t>(cell.size());
  std::memcpy(place, &offset, sizeof offset);
  std::memcpy(place + sizeof offset, &bytes, sizeof bytes);
  loose_.insert(loose_.end(), cell.begin(), cell.end());
  loose_.resize(Padded(loose_.size()));
}

std::span<std::byte> RowBatchWriter::FinishFrame(message::RowsHeader header) {
  if (!is_joined_) JoinLooseCells();
  header.rows = static_cast<std::uint32_t>(rows_);
  header.columns = static_cast<std::uint32_t>(sizes_.size());
  EncodeTo(header, std::span(frame_).subspan(kBody, kHeaderSize));
  return frame_;
}

/// Appends the cells of variable size and makes their offsets absolute.
void RowBatchWriter::JoinLooseCells() {
  is_joined_ = true;
  const auto start = static_cast<std::uint32_t>(frame_.size() - kBody);
  std::size_t place = first_row_;
  for (std::size_t row = 0; row < rows_; ++row) {
    place += kStampSize;
    for (const std::uint32_t size : sizes_) {
      if (size == 0) {
        std::uint32_t offset = 0;
        std::memcpy(&offset, frame_.data() + place, sizeof offset);
        offset += start;
        std::memcpy(frame_.data() + place, &offset, sizeof offset);
      }
      place += PlaceSize(size);
    }
  }
  frame_.insert(frame_.end(), loose_.begin(), loose_.end());
}

std::optional<RowBatchReader> RowBatchReader::Open(std::span<const std::byte> body) {
  RowBatchReader reader(body);
  if (!reader.ReadLayout() || !reader.LooseCellsFit()) return std::nullopt;
  return reader;
}

bool RowBatchReader::ReadLayout() {
  if (body_.size() < kHeaderSize || !Decode(body_.first(kHeaderSize), header_)) return false;
  const std::size_t columns = header_.columns;
  if (columns > (body_.size() - kHeaderSize) / sizeof(std::uint32_t)) return false;
  first_row_ = Padded(kHeaderSize + columns * sizeof(std::uint32_t));
  row_size_ = kStampSize;
  columns_.reserve(columns);
  for (std::size_t i = 0; i < columns; ++i) {
    const auto size = At<std::uint32_t>(kHeaderSize + i * sizeof(std::uint32_t));
    columns_.push_back({.offset = row_size_, .size = size});
    row_size_ += PlaceSize(size);
  }
  return first_row_ <= body_.size() && header_.rows <= (body_.size() - first_row_) / row_size_;
}

bool RowBatchReader::LooseCellsFit() const {
  for (std::size_t row = 0; row < header_.rows; ++row) {
    for (const ColumnPlace& column : columns_) {
      if (column.size != 0) continue;
      const std::size_t place = first_row_ + row * row_size_ + column.offset;
      const auto offset = At<std::uint32_t>(place);
      const auto size = At<std::uint32_t>(place + sizeof offset);
      if (offset > body_.size() || size > body_.size() - offset) return false;
    }
  }
  return true;
}

std::uint64_t RowBatchReader::tick(std::size_t row) const {
  return At<std::uint64_t>(first_row_ + row * row_size_);
}

std::int64_t RowBatchReader::time(std::size_t row) const {
  return At<std::int64_t>(first_row_ + row * row_size_ + sizeof(std::uint64_t));
}

std::span<const std::byte> RowBatchReader::cell(std::size_t row, std::size_t column) const {
  const ColumnPlace& place = columns_[column];
  const std::size_t position = first_row_ + row * row_size_ + place.offset;
  if (place.size != 0) return body_.subspan(position, place.size);
  const auto offset = At<std::uint32_t>(position);
  return body_.subspan(offset, At<std::uint32_t>(position + sizeof offset));
}

template <typename T>
T RowBatchReader::At(std::size_t position) const {
  T value{};
  std::memcpy(&value, body_.data() + position, sizeof value);
  return value;
}

}  // namespace tendon
