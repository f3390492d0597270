#pragma once

#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/process/membership_messages.h>

#include <cstdint>
#include <string>
#include <string_view>

/// Looks up names that people type in a catalogue. Errors are of code kNotFound unless noted, and
/// name what is missing and similar names. The pointers are valid until the catalogue changes.
namespace tendon {

Result<const ProcessEntry*> LookUpProcess(const Catalogue& catalogue, const std::string& process);
Result<const ComponentDescription*> LookUpComponent(const Catalogue& catalogue,
                                                    const std::string& process,
                                                    const std::string& component);
Result<const ProvidedDescription*> LookUpProvided(const Catalogue& catalogue,
                                                  const InterfaceName& name);
Result<const RequiredDescription*> LookUpRequired(const Catalogue& catalogue,
                                                  const InterfaceName& name);

/// A command, or a column of a state table as a read command.
Result<MemberDescription> LookUpCommand(const Catalogue& catalogue, const Path& path);

/// Whether a call or an event carries an argument.
[[nodiscard]] bool TakesArgument(const Signature& signature);

/// What a connect does if the required interface is connected already.
enum class Occupied { kRefused, kReplaced };

/// The order for a connect, checked against the catalogue. Errors: kInvalid, kNotFound;
/// kIncompatible, in the words of Refusal(); kExists if the required interface is connected;
/// kFailed if its process is absent. An absent or unknown provider process is allowed, and the
/// connection will be pending; but it must not replace an active one (kFailed, kNotFound). A
/// missing interface of a present process is an error.
Result<message::Wiring> PlanConnect(const Catalogue& catalogue, const message::Wire& wire,
                                    Occupied occupied = Occupied::kRefused);

/// The same order, unchecked.
[[nodiscard]] message::Wiring WiringOf(const Catalogue& catalogue, const message::Wire& wire);

/// The connection that a disconnect would end. Errors: kInvalid, kNotFound; kFailed if it is not
/// connected or its process is absent.
Result<ConnectionDescription> PlanDisconnect(const Catalogue& catalogue,
                                             const InterfaceName& required);

/// The required interface that `text` names: by its path, or by the number of its connection: "12",
/// or "desk/12" if several processes have a connection of that number (else kInvalid).
Result<InterfaceName> LookUpConnected(const Catalogue& catalogue, const std::string& text);

/// Changes at each start of the process; 0 if there is no process of that name.
[[nodiscard]] std::uint64_t InstanceOf(const Catalogue& catalogue, const std::string& process);

/// Whether the process can be reached: it is there, perhaps slow.
[[nodiscard]] bool IsPresent(const ProcessDescription& process);

/// How the reason of a lost process begins if it fell silent while its link was open.
inline constexpr std::string_view kNoRenewal = "no renewal of its lease for ";

/// Whether the process was lost by silence: it may be suspended, hang, or be cut off, and may come
/// back. A process whose link broke has ended.
[[nodiscard]] bool HasFallenSilent(const ProcessDescription& process);

/// The remedy if a process is gone: "start it again", or for a silent one, how to wake or to end
/// its program.
[[nodiscard]] std::string AdviceFor(const ProcessDescription& process);

/// kFailed, "process 'robot' is lost (reason)" or "is starting", unless it is present.
Result<void> RequirePresent(const ProcessDescription& process);

}  // namespace tendon
