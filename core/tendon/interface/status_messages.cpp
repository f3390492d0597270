#include <tendon/interface/status_messages.h>

#include <utility>

namespace tendon {

StatusMessages::StatusMessages(ProvidedInterface& interface, std::string source)
    : source_(std::move(source)) {
  interface.AddEvent(status_, "Status");
  interface.AddEvent(warning_, "Warning");
  interface.AddEvent(error_, "Error");
}

void StatusMessages::Send(LogLevel level, WriteEvent<std::string>& event, std::string_view text) {
  Scratch<std::string>::Use copy(text_);
  copy->assign(text);
  event(*copy);
  Log(level, source_, text);
}

}  // namespace tendon
