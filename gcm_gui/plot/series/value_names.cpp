#include <gcm_gui/plot/series/value_names.h>

#include <algorithm>

namespace tendon::gui {

std::optional<QString> ValueNames::nameOf(std::int64_t value) const {
  const auto found =
      std::lower_bound(all.begin(), all.end(), value,
                       [](const Entry& one, std::int64_t wanted) { return one.value < wanted; });
  if (found == all.end() || found->value != value) return std::nullopt;
  return found->name;
}

QString ValueNames::textOf(const ExactNumber& number) const {
  if (number.kind() != ExactNumber::Kind::kSigned) return number.text();
  return nameOf(static_cast<std::int64_t>(number.word())).value_or(number.text());
}

}  // namespace tendon::gui
