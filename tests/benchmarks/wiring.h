#pragma once

#include <benchmarks/floors.h>
#include <tendon/interface/connection.h>
#include <tendon/state/state_table.h>

#include <array>
#include <cstdint>
#include <memory>

namespace tendon::benchmark {

using Argument = std::array<double, 7>;  // 56 bytes: one cache line with the command

/// A state table with one column.
template <typename T>
struct Table {
  T variable{};
  StateTable table;

  Table() {
    table.Add(variable, "Value");
    table.SetLength(StateTable::kMinimumLength);
    table.Prepare();
    table.Advance({});
  }
  void Store(const T& value) {
    variable = value;
    table.Advance({});
  }
  [[nodiscard]] const Column<T>& column() const { return table.Find(variable); }
};

/// A connected server and client without threads. The benchmark calls both in its own threads.
class Wiring {
 public:
  Wiring() {
    control_.AddCommandWrite(&Wiring::Take, this, "Take");
    control_.AddCommandReadState(table_.table, table_.variable, "Get");
    server_.AddFunction(take, "Take");
    server_.AddFunction(get, "Get");
    server_.SetMailboxCapacity(kCapacity);
    inbox_.SetAccepting(true);
    client_inbox_.SetAccepting(true);
    connection_ = *Connection::Make(server_, control_, "client/Server", "server/Control");
  }

  /// Executes the queued commands; called in the server's thread.
  std::size_t Execute() { return inbox_.ExecuteQueued(); }
  [[nodiscard]] std::uint64_t taken() const { return taken_; }

  WriteFunction<Argument> take;
  ReadFunction<Message> get;

 private:
  void Take(const Argument& argument) {
    last_ = argument;
    ++taken_;
  }

  Table<Message> table_;
  Wakeup<> wakeup_;
  Inbox inbox_{&wakeup_};
  Inbox client_inbox_;
  ProvidedInterface control_{"Control", &inbox_};
  RequiredInterface server_{"Server", &client_inbox_};
  std::unique_ptr<Connection> connection_;
  // Used by the server's thread; in another cache line than the client's data.
  alignas(kSeparation) Argument last_{};
  std::uint64_t taken_ = 0;
};

}  // namespace tendon::benchmark
