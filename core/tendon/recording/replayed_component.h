#pragma once

#include <tendon/base/rate_limited_warning.h>
#include <tendon/manager/component_description.h>
#include <tendon/recording/replayed_members.h>
#include <tendon/state/state_table.h>
#include <tendon/task/component.h>

#include <memory>
#include <string>
#include <vector>

namespace tendon::recording {

/// A component with the interfaces of a recorded component: its state tables, events and commands.
/// Observers of its commands see only the recorded calls. All commands are refused, except some
/// read commands. If the reply is a structure, exactly one column of the component has the same
/// type, and this column was recorded, the reply is the newest value of the column. In most
/// components, such a command returns this value.
class ReplayedComponent final : public Component {
 public:
  struct Options {
    /// The recorded description; null if the recording has none. Used only by the constructor.
    const ComponentDescription* description = nullptr;
    std::string refusal;  ///< the reason why commands are refused: "this is a replay of run.mcap"
  };

  /// Throws ConfigurationError like ReplayedMembers.
  ReplayedComponent(std::string name, std::shared_ptr<ReplayedMembers> members,
                    const Options& options);

  [[nodiscard]] std::vector<const StateTable*> tables() const override {
    return members_->tables();
  }
  [[nodiscard]] double period() const override { return period_; }

 private:
  void AddInterface(const ProvidedDescription& provided, const Options& options);
  void AddSilentEvent(const MemberDescription& event, ProvidedInterface& interface);

  const std::shared_ptr<ReplayedMembers> members_;
  double period_ = 0.0;
  // Events that are not in the recording.
  std::vector<std::unique_ptr<ReplayedEvent>> silent_events_;
  RateLimitedWarning refused_;
};

}  // namespace tendon::recording
