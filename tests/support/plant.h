#pragma once

#include <tendon/task/periodic_task.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "support/record.h"

/// Two components for tests of connections: a plant with every kind of command and event, and an
/// operator that uses all of them.
namespace plant {

/// A payload of fixed size; the number identifies a call.
struct Move {
  std::uint64_t number = 0;
  std::array<double, 3> goal{};

  bool operator==(const Move&) const = default;
};

/// A payload of dynamic size.
struct Note {
  std::string text;
  std::vector<double> values;

  bool operator==(const Note&) const = default;
};

/// A type with the same fields as Move that is not Move.
struct OtherMove {
  std::uint64_t number = 0;
  std::array<double, 3> goal{};
};

}  // namespace plant

template <>
inline constexpr auto tendon::kPayload<plant::Move> =
    tendon::Describe("plant.Move", tendon::Field{"number", &plant::Move::number},
                     tendon::Field{"goal", &plant::Move::goal, "rad"});
template <>
inline constexpr auto tendon::kPayload<plant::Note> =
    tendon::Describe("plant.Note", tendon::Field{"text", &plant::Note::text},
                     tendon::Field{"values", &plant::Note::values});
template <>
inline constexpr auto tendon::kPayload<plant::OtherMove> =
    tendon::Describe("plant.Move", tendon::Field{"number", &plant::OtherMove::number},
                     tendon::Field{"goal", &plant::OtherMove::goal, "deg"});

namespace plant {

using tendon::test::Record;

/// Executes commands at 1 kHz, raises an event for each, and records a row per cycle.
class Plant final : public tendon::PeriodicTask {
 public:
  explicit Plant(std::string name);
  ~Plant() override { Join(); }

  void Run() override { ProcessQueuedCommands(); }

  Record<Move> moves;
  Record<Note> notes;
  Record<int> stops;
  mutable std::mutex gate;            ///< callers wait while it is locked
  mutable std::atomic<int> asked{0};  ///< the number of callers that have reached the gate

 private:
  void Stop();
  void MoveTo(const Move& move);
  void Write(const Note& note);
  void Ask(std::uint64_t& result) const;

  Move move_;
  Note note_;
  tendon::VoidEvent stopped_;
  tendon::WriteEvent<Move> moved_;
  tendon::WriteEvent<Note> written_;
};

/// A component without a thread: the test calls its functions and executes its received events.
class Operator final : public tendon::Component {
 public:
  explicit Operator(std::string name, std::size_t capacity = 64);

  std::size_t Process() { return inbox()->ExecuteQueued(); }

  tendon::VoidFunction stop;
  tendon::WriteFunction<Move> move_to;
  tendon::WriteFunction<Note> write;
  tendon::ReadFunction<Move> get_move;
  tendon::ReadFunction<Note> get_note;
  tendon::QualifiedReadFunction<double, Move> get_scaled;
  tendon::ReadFunction<std::uint64_t> ask;

  std::vector<Move> moved;
  std::vector<Note> written;
  int stopped = 0;

 private:
  void OnStopped() { ++stopped; }
  void OnMoved(const Move& move) { moved.push_back(move); }
  void OnWritten(const Note& note) { written.push_back(note); }
};

/// Its interfaces lack members, or have members of the wrong types.
class Impostor final : public tendon::Component {
 public:
  explicit Impostor(std::string name);

 private:
  void MoveTo(const OtherMove& /*move*/) {}
};

}  // namespace plant
