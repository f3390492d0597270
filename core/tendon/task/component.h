#pragma once

#include <tendon/base/result.h>
#include <tendon/interface/inbox.h>
#include <tendon/interface/provided_interface.h>
#include <tendon/interface/required_interface.h>
#include <tendon/lockfree/flag.h>
#include <tendon/task/component_state.h>

#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace tendon {

/// A named object with interfaces and a life cycle, and no thread of its own: its commands and
/// event handlers run in the threads that call them. A Task adds a thread.
///
/// The constructor of a derived class adds the interfaces; a manager owns the component and drives
/// its life. Functions below "for managers" are called by one thread at a time.
class Component {
 public:
  explicit Component(std::string name);
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;
  virtual ~Component();

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Any thread.
  [[nodiscard]] ComponentState state() const noexcept { return state_.Get(); }
  /// Why it is faulted: the exception's message and where it was thrown. Any thread; allocates.
  [[nodiscard]] std::string fault() const;
  /// s between two cycles, 0 where it has none.
  [[nodiscard]] virtual double period() const { return 0.0; }
  /// Empty unless it is a task.
  [[nodiscard]] virtual std::vector<const StateTable*> tables() const { return {}; }

  /// Null where there is none.
  [[nodiscard]] ProvidedInterface* FindProvided(const std::string& name) const;
  [[nodiscard]] RequiredInterface* FindRequired(const std::string& name) const;
  [[nodiscard]] std::vector<ProvidedDescription> provided() const;
  [[nodiscard]] std::vector<RequiredDescription> required() const;

  // For managers.

  /// Ends the construction: from now on no interface and no member can be added.
  virtual void Seal();
  /// Configures it where needed and lets it run, as the table of ComponentState says. Returns once
  /// it is active, or why it is not.
  Result<void> Start();
  /// Returns once its thread, if any, has ended and Cleanup() has run.
  Result<void> Stop();
  /// Called after each change of the state, in the thread that made it; must not call back.
  void SetStateObserver(std::function<void()> observer);

 protected:
  /// For components whose calls wait in an inbox until somebody executes them.
  Component(std::string name, std::unique_ptr<Inbox> inbox);

  /// A second interface of one name, a bad name, or a sealed component: ConfigurationError. The
  /// names `state` and `state-...` are reserved for state tables.
  ProvidedInterface& AddProvidedInterface(std::string name);
  RequiredInterface& AddRequiredInterface(std::string name, Need need = Need::kRequired);

  /// Before the first start, and again before a restart after a fault. May throw.
  virtual void Configure() {}
  /// Before the first cycle, in the component's thread if it has one. May throw.
  virtual void Startup() {}
  /// After the last cycle, in the component's thread if it has one. May throw.
  virtual void Cleanup() {}

  /// Lets the component run until Halt(); a task starts its thread.
  virtual Result<void> Launch();
  virtual void Halt();

  /// Runs one of the author's functions; an exception faults the component, named after `where`.
  template <typename Body>
  bool RunGuarded(const char* where, Body body) {
    try {
      body();
      return true;
    } catch (const std::exception& error) {
      EnterFault(where, error.what());
    } catch (...) {
      EnterFault(where, "an exception that is no std::exception");
    }
    return false;
  }
  void EnterFault(const char* where, const std::string& reason);
  void SetState(ComponentState state);

  ProvidedInterface& AddReservedInterface(std::string name);
  [[nodiscard]] Inbox* inbox() const { return inbox_.get(); }

 private:
  void CheckNew(const std::string& what, const std::string& name) const;

  std::string name_;
  std::unique_ptr<Inbox> inbox_;
  bool sealed_ = false;
  std::vector<std::unique_ptr<ProvidedInterface>> provided_;
  std::vector<std::unique_ptr<RequiredInterface>> required_;
  Published<ComponentState> state_{ComponentState::kConstructed};
  mutable std::mutex mutex_;  // of fault_ and observer_
  std::string fault_;
  std::function<void()> observer_;
};

}  // namespace tendon
