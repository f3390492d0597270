#pragma once

#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/process/membership_messages.h>

#include <cstdint>
#include <string>
#include <string_view>

/// Looks up, in a catalogue, names that people type. Errors have the code kNotFound if not noted
/// otherwise; they say what is missing and suggest similar names. The pointers are valid until the
/// catalogue changes.
namespace tendon {

Result<const ProcessEntry*> LookUpProcess(const Catalogue& catalogue, const std::string& process);
Result<const ComponentDescription*> LookUpComponent(const Catalogue& catalogue,
                                                    const std::string& process,
                                                    const std::string& component);
Result<const ProvidedDescription*> LookUpProvided(const Catalogue& catalogue,
                                                  const InterfaceName& name);
Result<const RequiredDescription*> LookUpRequired(const Catalogue& catalogue,
                                                  const InterfaceName& name);

/// Finds a command. A column of a state table counts as a read command.
Result<MemberDescription> LookUpCommand(const Catalogue& catalogue, const Path& path);

/// True if a call or an event has an argument.
[[nodiscard]] bool TakesArgument(const Signature& signature);

/// Checks a connect against the catalogue, and returns the order for the required side's LCM.
/// Errors: kInvalid; kNotFound, also for a missing interface of a present process; kIncompatible,
/// with the text of Refusal(); kExists if the required interface is connected; kFailed if its
/// process is absent.
///
/// If the provider's process is absent or unknown, the connection will be pending. A pending
/// connection cannot replace an active one: kFailed for an absent process, kNotFound for an unknown
/// one.
Result<message::ConnectionPlan> PlanConnect(const Catalogue& catalogue, const message::Wire& wire,
                                            WhenConnected when_connected = WhenConnected::kRefuse);

/// The order that PlanConnect() returns, without its checks.
[[nodiscard]] message::ConnectionPlan ConnectionPlanOf(const Catalogue& catalogue,
                                                       const message::Wire& wire);

/// The connection that a disconnect would end. Errors: kInvalid, kNotFound; kFailed if it is not
/// connected or its process is absent.
Result<ConnectionDescription> PlanDisconnect(const Catalogue& catalogue,
                                             const InterfaceName& required);

/// Finds a required interface by its path or by the number of its connection: "12", or "desk/12" if
/// several processes have a connection with that number (otherwise kInvalid).
Result<InterfaceName> LookUpConnected(const Catalogue& catalogue, const std::string& text);

/// The instance of a process, which changes at each start; 0 if there is no process with that name.
[[nodiscard]] std::uint64_t InstanceOf(const Catalogue& catalogue, const std::string& process);

/// True if the process is present, even if it is slow.
[[nodiscard]] bool IsPresent(const ProcessDescription& process);

/// ProcessDescription::reason begins with this text if a process was lost because it was silent
/// while its link was open.
inline constexpr std::string_view kNoRenewal = "no renewal of its lease for ";

/// True if the process was lost because it was silent: it may be suspended, hang, or be
/// disconnected from the network, and may come back. A process whose link broke has ended.
[[nodiscard]] bool HasFallenSilent(const ProcessDescription& process);

/// The remedy if a process is gone: "start it again", or for a silent process, how to resume or end
/// its program.
[[nodiscard]] std::string AdviceFor(const ProcessDescription& process);

/// Fails if the process is not present: kFailed, "process 'robot' is lost (reason)" or "is
/// starting".
Result<void> RequirePresent(const ProcessDescription& process);

}  // namespace tendon
