#pragma once

#include <tendon/middleware/frame.h>
#include <tendon/process/viewer_messages.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tendon {

/// Builds the body of kRows. One object builds all batches; it allocates nothing when its buffers
/// have become large enough.
class RowBatchWriter {
 public:
  /// `sizes` has one element per column: the number of bytes of a cell, or 0 if this number differs
  /// from row to row.
  explicit RowBatchWriter(std::vector<std::uint32_t> sizes);

  void Clear();
  void BeginRow(std::uint64_t tick, std::int64_t time);
  /// Adds the next cell of the row. The cell must have the size of its column. If this size is 0,
  /// the cell may have any size.
  void AddCell(std::span<const std::byte> cell);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  /// Returns the size of the finished body, in bytes.
  [[nodiscard]] std::size_t size() const {
    return frame_.size() - FrameHeader::kSize + loose_.size();
  }
  /// Returns the body. Fills in `rows` and `columns` of the header. The other fields may be
  /// different for each viewer.
  std::span<const std::byte> Finish(const message::RowsHeader& header) {
    return FinishFrame(header).subspan(FrameHeader::kSize);
  }
  /// Like Finish(), but the result also has space for the frame's header before the body, for
  /// Channel::NotifyInPlace().
  std::span<std::byte> FinishFrame(message::RowsHeader header);

 private:
  void JoinLooseCells();

  const std::vector<std::uint32_t> sizes_;
  std::size_t first_row_ = 0;  // offset in the frame
  std::size_t row_size_ = 0;
  std::size_t rows_ = 0;
  std::size_t column_ = 0;
  std::size_t position_ = 0;  // offset of the next cell in the frame
  bool is_joined_ = false;
  Bytes frame_;  // space for the frame's header, then the body
  Bytes loose_;  // cells of variable size, until they are appended to the rows
};

/// Reads the body of kRows, which is untrusted.
class RowBatchReader {
 public:
  /// Returns no reader if the layout of the body is invalid. The body must outlive the reader.
  static std::optional<RowBatchReader> Open(std::span<const std::byte> body);

  [[nodiscard]] const message::RowsHeader& header() const { return header_; }
  [[nodiscard]] std::uint64_t tick(std::size_t row) const;
  [[nodiscard]] std::int64_t time(std::size_t row) const;
  /// Returns a cell; empty if there was no value.
  [[nodiscard]] std::span<const std::byte> cell(std::size_t row, std::size_t column) const;

 private:
  explicit RowBatchReader(std::span<const std::byte> body) : body_(body) {}
  [[nodiscard]] bool ReadLayout();
  [[nodiscard]] bool LooseCellsFit() const;
  template <typename T>
  [[nodiscard]] T At(std::size_t position) const;

  struct ColumnPlace {
    std::size_t offset = 0;  // offset in a row
    std::uint32_t size = 0;
  };

  std::span<const std::byte> body_;
  message::RowsHeader header_;
  std::vector<ColumnPlace> columns_;
  std::size_t first_row_ = 0;
  std::size_t row_size_ = 0;
};

}  // namespace tendon
