#pragma once

#include <tendon/interface/offer.h>
#include <tendon/interface/provided_interface.h>
#include <tendon/state/state_table.h>

#include <cstddef>
#include <memory>

namespace tendon {

/// A read command that returns the newest cell of a column as it is stored in the table: a CDR
/// body, which a caller with the column's type converts. kNoSample before the first row, and if the
/// newest row has no value. `table` must outlive it.
class ColumnOffer final : public Offer {
 public:
  /// The output type of `description` is that of the column.
  ColumnOffer(MemberDescription description, const StateTable& table, std::size_t column);

  [[nodiscard]] bool uses_mailbox() const override { return false; }
  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const override;

 private:
  const StateTable& table_;
  const std::size_t column_;
};

/// Adds one such command per column to `interface`, through which others read the table. `table`
/// must outlive `interface`.
void AddColumnReads(const StateTable& table, ProvidedInterface& interface);

}  // namespace tendon
