#pragma once

#include <gcm_gui/plot/series/exact_number.h>

#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace tendon::gui {

/// The names of a signal's values: those of an enumeration, or "false" and "true".
struct ValueNames {
  struct Entry {
    std::int64_t value = 0;
    QString name;

    bool operator==(const Entry&) const = default;
  };

  QString type;            ///< "arm.Mode", "bool"
  std::vector<Entry> all;  ///< by value

  /// The name of a number; its digits if it has no name.
  [[nodiscard]] QString textOf(const ExactNumber& number) const;
  /// Empty for a value without a name.
  [[nodiscard]] std::optional<QString> nameOf(std::int64_t value) const;

  bool operator==(const ValueNames&) const = default;
};

/// Null for a signal with plain numbers.
using ValueNamesPointer = std::shared_ptr<const ValueNames>;

}  // namespace tendon::gui
