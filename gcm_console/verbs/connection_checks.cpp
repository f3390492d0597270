#include <gcm_console/verbs/connection_checks.h>

namespace console {

tendon::Result<void> CheckOrder(const std::string& verb, const tendon::Catalogue& catalogue,
                                const tendon::InterfaceName& required,
                                const tendon::InterfaceName& provided) {
  const bool is_swapped = catalogue.FindRequired(required) == nullptr &&
                          catalogue.FindProvided(required) != nullptr &&
                          catalogue.FindRequired(provided) != nullptr;
  if (!is_swapped) return {};
  return tendon::Error{tendon::ErrorCode::kInvalid,
                       ToString(required) +
                           " is a provided interface, but the required interface comes first; in "
                           "the right order: gcm " +
                           verb + " " + ToString(provided) + " " + ToString(required)};
}

void LearnConflictingTypes(Context& context) {
  static_cast<void>(context.Ask<void>(
      [](tendon::GcmClient& client, auto handler) { client.LearnConflictingTypes(handler); }));
}

}  // namespace console
