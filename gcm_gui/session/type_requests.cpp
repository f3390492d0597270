#include <gcm_gui/session/type_requests.h>

namespace tendon::gui {

void TypeRequests::want(Fingerprint type, const std::string& process) {
  wanted_[type].process = process;
}

std::vector<std::pair<Fingerprint, std::string>> TypeRequests::takeDue(SteadyTime now) {
  std::vector<std::pair<Fingerprint, std::string>> due;
  for (auto& [type, one] : wanted_) {
    const bool is_known = one.reply && one.reply->ok();
    if (is_known || one.is_asking || now < one.due) continue;
    one.is_asking = true;
    due.emplace_back(type, one.process);
  }
  return due;
}

void TypeRequests::onReply(Fingerprint type, const Result<Schema>& reply, SteadyTime now) {
  Request& one = wanted_[type];
  one.is_asking = false;
  one.reply = reply;
  one.due = now + one.backoff.Next();
}

const Result<Schema>* TypeRequests::find(Fingerprint type) const {
  const auto found = wanted_.find(type);
  return found == wanted_.end() || !found->second.reply ? nullptr : &*found->second.reply;
}

}  // namespace tendon::gui
