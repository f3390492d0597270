#pragma once

#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/event_sink.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/process/membership_messages.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Functions that search a catalogue for names that people have typed. Errors have the code
/// kNotFound, say what is missing, and suggest similar names; comments mention other codes.
/// Returned pointers are valid until the catalogue changes.
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

/// Returns the descriptions of the events, in the order of the request, and then those of the
/// commands, as DescribeCalls() returns them. Fails with kInvalid for a read command.
Result<std::vector<MemberDescription>> LookUpEvents(const Catalogue& catalogue,
                                                    const EventSubscription& wanted);

/// Returns true if a call or an event of a member with this signature has an argument.
[[nodiscard]] bool TakesArgument(const Signature& signature);

/// Checks with the catalogue whether a connection can be made, and returns the order for the LCM of
/// the required side. Errors:
/// - kInvalid: a name is invalid.
/// - kNotFound: the required interface does not exist, or the provided interface does not exist in
///   a present process.
/// - kIncompatible: the interfaces do not fit; the text comes from Refusal().
/// - kExists: the required interface is connected and may not be replaced.
/// - kFailed: the process of the required side is absent.
///
/// If the provider's process is absent or unknown, the new connection will be pending. A pending
/// connection cannot replace an active one; the error is kFailed for an absent process, and
/// kNotFound for an unknown process.
Result<message::ConnectionPlan> PlanConnect(const Catalogue& catalogue,
                                            const message::ConnectionEnds& ends,
                                            WhenConnected when_connected = WhenConnected::kRefuse);

/// Returns the same order as PlanConnect(), but checks nothing.
[[nodiscard]] message::ConnectionPlan ConnectionPlanOf(const Catalogue& catalogue,
                                                       const message::ConnectionEnds& ends);

/// Returns the connection that a disconnect of the required interface would end. Errors: kInvalid
/// for an invalid name; kNotFound; kFailed if the interface is not connected or its process is
/// absent.
Result<ConnectionDescription> PlanDisconnect(const Catalogue& catalogue,
                                             const InterfaceName& required);

/// Finds a required interface by its path or by the number of its connection: "12" or "desk/12".
/// Fails with kInvalid if several processes have a connection with the number "12".
Result<InterfaceName> LookUpConnected(const Catalogue& catalogue, const std::string& text);

/// Returns the instance of a process, a number that is new at each start; 0 if there is no process
/// with this name.
[[nodiscard]] std::uint64_t InstanceOf(const Catalogue& catalogue, const std::string& process);

/// Returns true if the process is present. It may be slow (ProcessState::kSuspect).
[[nodiscard]] bool IsPresent(const ProcessDescription& process);

/// The beginning of ProcessDescription::reason for a process that was lost because it was silent
/// while its link was open.
inline constexpr std::string_view kNoRenewal = "no renewal of its lease for ";

/// Returns true if the process was lost because it was silent while its link was open. This process
/// may be suspended, hang, or be cut off from the network, and may come back. Returns false if the
/// link of the process broke, because then the process has ended.
[[nodiscard]] bool HasFallenSilent(const ProcessDescription& process);

/// Returns the remedy for a process that is not present: "start it again". If HasFallenSilent() is
/// true, says how to resume or end the program instead.
[[nodiscard]] std::string AdviceFor(const ProcessDescription& process);

/// Fails with kFailed if the process is not present: "process 'robot' is lost (reason)" or "is
/// starting".
Result<void> RequirePresent(const ProcessDescription& process);

}  // namespace tendon
