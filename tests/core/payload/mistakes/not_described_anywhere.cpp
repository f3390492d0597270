#include <tendon/interface/provided_interface.h>
#include <tendon/interface/required_interface.h>
#include <tendon/manager/component_registry.h>

// The framework receives each of these types once.
// error: T is not described: write kPayload<T> beside it
struct Sent {};
// error: T is not described: write kPayload<T> beside it
struct Asked {};
// error: T is not described: write kPayload<T> beside it
struct Raised {};
// error: T is not described: write kPayload<T> beside it
struct Awaited {};
// error: T is not described: write kPayload<T> beside it
struct Kept {};
// error: T is not described: write kPayload<T> beside it
struct Listed {};
// error: T is not described: write kPayload<T> beside it
struct Filtered {};
// error: T is not described: write kPayload<T> beside it
struct Written {};
// error: T is not described: write kPayload<T> beside it
struct Returned {};
// error: T is not described: write kPayload<T> beside it
struct Questioned {};
// error: T is not described: write kPayload<T> beside it
struct ReadInAnyThread {};
// error: T is not described: write kPayload<T> beside it
struct WrittenInAnyThread {};
// error: T is not described: write kPayload<T> beside it
struct Handled {};
// error: T is not described: write kPayload<T> beside it
struct HandledInAnyThread {};

struct Component {
  tendon::WriteFunction<Sent> send;
  tendon::QualifiedReadFunction<Asked, int> ask;
  tendon::WriteEvent<Raised> raised;
  tendon::EventWaiter<Awaited> awaited;
  tendon::StateTable table;
  Kept kept;
  Listed listed;

  Component(tendon::ProvidedInterface& provided, tendon::RequiredInterface& required) {
    table.Add(kept, "Kept");
    table.Add(listed, "Listed", 100);
    provided.AddCommandFilteredWrite(&Filter, &Component::Take, this, "Filtered");
    provided.AddCommandWrite(&Component::Write, this, "Write");
    provided.AddCommandVoidReturn(&Component::Return, this, "Return");
    provided.AddCommandWriteReturn(&Component::Answer, this, "Answer");
    provided.AddCommandRead(&Component::Read, this, "Read", tendon::kThreadSafe);
    provided.AddCommandWrite(&Component::WriteSafely, this, "WriteSafely", tendon::kThreadSafe);
    required.AddEventHandlerWrite(&Component::Handle, this, "Handled");
    required.AddEventHandlerWrite(&Component::HandleSafely, this, "Seen", tendon::kThreadSafe);
  }
  static void Filter(const Filtered& in, int& out);
  void Take(int number);
  void Write(const Written& value);
  void Return(Returned& value);
  void Answer(const Questioned& question, int& answer);
  void Read(ReadInAnyThread& value) const;
  void WriteSafely(const WrittenInAnyThread& value);
  void Handle(const Handled& value);
  void HandleSafely(const HandledInAnyThread& value);
};

struct Configured : tendon::Component {
  // error: T is not described: write kPayload<T> beside it
  struct Configuration {};
  Configured(std::string name, const Configuration& /*configuration*/)
      : tendon::Component(std::move(name)) {}
};

void Register(tendon::ComponentRegistry& registry) { registry.Add<Configured>("Configured"); }
