#pragma once

#include <gcm_gui/plot/series/exact_number.h>

#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace tendon::gui {

/// The names of a signal's values: the enumerators of an enumeration, or "false" and "true".
struct ValueNames {
  struct Entry {
    std::int64_t value = 0;
    QString name;

    bool operator==(const Entry&) const = default;
  };

  QString type;            ///< "arm.Mode", "bool"
  std::vector<Entry> all;  ///< by value

  /// Returns the name of a number; if it has no name, its digits.
  [[nodiscard]] QString textOf(const ExactNumber& number) const;
  /// Returns the name of a value; empty if it has none.
  [[nodiscard]] std::optional<QString> nameOf(std::int64_t value) const;

  bool operator==(const ValueNames&) const = default;
};

/// Null if the signal has plain numbers.
using ValueNamesPointer = std::shared_ptr<const ValueNames>;

}  // namespace tendon::gui
