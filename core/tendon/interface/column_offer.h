#pragma once

#include <tendon/interface/offer.h>
#include <tendon/interface/provided_interface.h>
#include <tendon/state/state_table.h>

#include <cstddef>
#include <memory>

namespace tendon {

/// A read command that returns the newest cell of a column as the table stores it: a CDR body,
/// which a caller with the column's type converts. Returns kNoSample before the first row, or if
/// the newest row has no value. The table must outlive the offer.
class ColumnOffer final : public Offer {
 public:
  /// `description` must have the type of the column as its output type.
  ColumnOffer(MemberDescription description, const StateTable& table, std::size_t column);

  [[nodiscard]] bool uses_mailbox() const override { return false; }
  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const override;

 private:
  const StateTable& table_;
  const std::size_t column_;
};

/// Adds one such command per column to `interface`, so that other components can read the table.
/// `table` must outlive `interface`.
void AddColumnReads(const StateTable& table, ProvidedInterface& interface);

}  // namespace tendon
