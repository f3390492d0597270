#include <gcm_console/wire/disputed_types.h>

namespace console {

void LearnDisputedTypes(Context& context) {
  static_cast<void>(context.Ask<void>(
      [](tendon::GcmClient& client, auto handler) { client.LearnDisputedTypes(handler); }));
}

}  // namespace console
