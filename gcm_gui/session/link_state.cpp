#include <gcm_gui/session/link_state.h>

#include <gcm_gui/models/text.h>

namespace tendon::gui {

void LinkState::setAddress(const QString& address, bool hosted) {
  address_ = address;
  hosted_ = hosted;
  since_ = WallClock();
  Q_EMIT changed();
}

void LinkState::setFile(const QString& name) {
  is_file_ = true;
  setAddress(name, false);
}

void LinkState::setConnected() {
  reason_.clear();
  enter(State::kConnected);
}

void LinkState::setUnreachable(const QString& reason) {
  reason_ = reason;
  enter(state_ == State::kSearching ? State::kSearching : State::kLost);
}

void LinkState::enter(State state) {
  if (state != state_) since_ = WallClock();
  state_ = state;
  Q_EMIT changed();
}

}  // namespace tendon::gui
