#include <tendon/state/column.h>

#include <vector>

namespace tendon {

std::span<std::uint64_t> RowBuffer(std::size_t words) {
  thread_local std::vector<std::uint64_t> buffer;
  if (buffer.size() < words) buffer.resize(words);
  return std::span(buffer).first(words);
}

ColumnBase::ColumnBase(std::string name, const CellLayout& layout, const Schema& schema,
                       const Fingerprint& fingerprint)
    : name_(std::move(name)), layout_(layout), schema_(schema), fingerprint_(fingerprint) {}

std::span<const std::byte> ColumnBase::Cell(std::span<const std::uint64_t> row) const noexcept {
  const auto cell = row.subspan(layout_.offset, layout_.words);
  if (!layout_.is_dynamic) return std::as_bytes(cell).first(layout_.bytes);
  if (cell[0] == CellLayout::kAbsent) return {};
  return std::as_bytes(cell.subspan(1)).first(cell[0]);
}

std::span<const std::uint64_t> ColumnBase::Encode(std::span<std::uint64_t> cell) noexcept {
  if (!layout_.is_dynamic) {
    EncodeVariable(std::as_writable_bytes(cell).first(layout_.bytes));
    return cell;
  }
  const std::size_t size =
      EncodeVariable(std::as_writable_bytes(cell.subspan(1)).first(layout_.bytes));
  if (size == 0) absent_.Add();
  cell[0] = size == 0 ? CellLayout::kAbsent : size;
  return cell.first(1 + (size + 7) / 8);
}

}  // namespace tendon
