#include <tendon/task/state_interface.h>

#include <memory>
#include <vector>

namespace tendon {
namespace {

/// Reads the newest cell of one column as it is stored in the table: a CDR body.
class ColumnReadCommand final : public CommandBase {
 public:
  ColumnReadCommand(const StateTable& table, std::size_t column)
      : CommandBase(layout::kNone, layout::kNone), table_(table), column_(column) {}

  Status ExecuteEncoded(std::span<const std::byte> /*in*/, AnswerSink& out) override {
    Scratch<std::vector<std::uint64_t>>::Use row(row_);
    row->resize(table_.row_words());
    while (true) {
      const std::uint64_t next = table_.next_tick();
      if (next == 0) return Status::kNoSample;
      std::int64_t time = 0;
      if (table_.CopyRow(next - 1, *row, time) != RowResult::kDone) continue;  // overwritten
      const std::span<const std::byte> cell = table_.cell(*row, column_);
      if (cell.empty()) return Status::kNoSample;
      out.Take(cell);
      return Status::kDone;
    }
  }

 private:
  const StateTable& table_;
  std::size_t column_;
  Scratch<std::vector<std::uint64_t>> row_;
};

class ColumnOffer final : public Offer {
 public:
  ColumnOffer(MemberDescription description, const StateTable& table, std::size_t column)
      : Offer(std::move(description)), table_(table), column_(column) {}

  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* /*mailbox*/) const override {
    return std::make_unique<ColumnReadCommand>(table_, column_);
  }

 private:
  const StateTable& table_;
  std::size_t column_;
};

}  // namespace

void AddColumnReads(const StateTable& table, ProvidedInterface& interface) {
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    const ColumnBase& column = *table.columns()[i];
    MemberDescription description = DescribeMember<None, None>(column.name(), CommandKind::kRead);
    description.signature.out = column.fingerprint();
    description.out_type = column.schema().TypeName();
    interface.AddOffer(std::make_unique<ColumnOffer>(std::move(description), table, i))
        .SetSource({&table, &column});
  }
}

}  // namespace tendon
