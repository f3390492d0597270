#include "support/plant.h"

#include <chrono>
#include <memory>

namespace plant {
namespace {

void Scaled(const Move& move, const double& factor, Move& scaled) {
  scaled = move;
  for (double& one : scaled.goal) one *= factor;
}

}  // namespace

Plant::Plant(std::string name) : PeriodicTask(std::move(name), std::chrono::milliseconds(1)) {
  state_table().SetLength(4095);  // a sanitizer may delay a reader for some seconds
  state_table().Add(move_, "Move");
  state_table().Add(note_, "Note", 256);
  auto& control = AddProvidedInterface("Control");
  control.AddCommandVoid(&Plant::Stop, this, "Stop");
  control.AddCommandWrite(&Plant::MoveTo, this, "MoveTo");
  control.AddCommandWrite(&Plant::Write, this, "Write");
  control.AddCommandReadState(state_table(), move_, "GetMove");
  control.AddCommandReadState(state_table(), note_, "GetNote");
  control.AddCommandQualifiedRead(state_table(), move_, &Scaled, "GetScaled");
  control.AddCommandRead(&Plant::Ask, this, "Ask", tendon::kThreadSafe);
  control.AddEvent(stopped_, "Stopped");
  control.AddEvent(moved_, "Moved");
  control.AddEvent(written_, "Written");
}

void Plant::Stop() {
  stops.Add(0);
  stopped_();
}

void Plant::MoveTo(const Move& move) {
  move_ = move;
  moves.Add(move);
  moved_(move);
}

void Plant::Write(const Note& note) {
  note_ = note;
  notes.Add(note);
  written_(note);
}

void Plant::Ask(std::uint64_t& result) const {
  ++asked;
  const std::scoped_lock lock(gate);
  result = 42;
}

Operator::Operator(std::string name, std::size_t capacity)
    : Component(std::move(name), std::make_unique<tendon::Inbox>()) {
  auto& robot = AddRequiredInterface("Robot");
  robot.AddFunction(stop, "Stop");
  robot.AddFunction(move_to, "MoveTo");
  robot.AddFunction(write, "Write");
  robot.AddFunction(get_move, "GetMove");
  robot.AddFunction(get_note, "GetNote");
  robot.AddFunction(get_scaled, "GetScaled");
  robot.AddFunction(ask, "Ask");
  robot.AddEventHandlerVoid(&Operator::OnStopped, this, "Stopped");
  robot.AddEventHandlerWrite(&Operator::OnMoved, this, "Moved");
  robot.AddEventHandlerWrite(&Operator::OnWritten, this, "Written");
  robot.SetMailboxCapacity(capacity);
}

Impostor::Impostor(std::string name) : Component(std::move(name)) {
  auto& control = AddProvidedInterface("Control");
  control.AddCommandWrite(&Impostor::MoveTo, this, "MoveTo");
}

}  // namespace plant
