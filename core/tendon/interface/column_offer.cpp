#include <tendon/interface/column_offer.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace tendon {
namespace {

class ColumnReadCommand final : public CommandBase {
 public:
  ColumnReadCommand(const StateTable& table, std::size_t column)
      : CommandBase(layout::kNone, layout::kNone), table_(table), column_(column) {}

  Status ExecuteEncoded(std::span<const std::byte> /*in*/, ReplySink& out) override {
    Scratch<std::vector<std::uint64_t>>::Use row(row_);
    row->resize(table_.row_words());
    std::uint64_t tick = 0;
    std::int64_t time = 0;
    const RowResult read = table_.CopyNewestRow(tick, *row, time);
    if (read != RowResult::kDone) return ToStatus(read);
    const std::span<const std::byte> cell = table_.cell(*row, column_);
    if (cell.empty()) return Status::kNoSample;
    out.Take(cell);
    return Status::kDone;
  }

 private:
  const StateTable& table_;
  const std::size_t column_;
  Scratch<std::vector<std::uint64_t>> row_;
};

}  // namespace

ColumnOffer::ColumnOffer(MemberDescription description, const StateTable& table, std::size_t column)
    : Offer(std::move(description)), table_(table), column_(column) {
  SetSource({&table, table.columns()[column].get()});
  SetReadsTableOnly();
}

std::unique_ptr<CommandBase> ColumnOffer::Bind(Mailbox* /*mailbox*/) const {
  return std::make_unique<ColumnReadCommand>(table_, column_);
}

void AddColumnReads(const StateTable& table, ProvidedInterface& interface) {
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    const ColumnBase& column = *table.columns()[i];
    MemberDescription description = DescribeMember<None, None>(column.name(), CommandKind::kRead);
    description.signature.out = column.fingerprint();
    description.out_type = column.schema().TypeName();
    interface.AddOffer(std::make_unique<ColumnOffer>(std::move(description), table, i));
  }
}

}  // namespace tendon
