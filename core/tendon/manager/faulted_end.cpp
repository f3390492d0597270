#include <tendon/manager/faulted_end.h>

namespace tendon {

void SetEndFaulted(ConnectionDescription& connection, const std::string& component,
                   const std::string& fault) {
  connection.state = ConnectionState::kPending;
  connection.reason = "component '" + component + "' is faulted: " + fault +
                      "; it is connected again when that component is started";
}

}  // namespace tendon
