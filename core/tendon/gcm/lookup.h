#pragma once

#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalog.h>
#include <tendon/process/membership_messages.h>

#include <cstdint>
#include <string>
#include <string_view>

/// Names that people type, looked up in a catalogue. Errors are of code kNotFound unless they say
/// otherwise, name what is missing and what is near. The pointers live as long as the catalogue is
/// not changed.
namespace tendon {

Result<const ProcessEntry*> LookUpProcess(const Catalog& catalog, const std::string& process);
Result<const ComponentDescription*> LookUpComponent(const Catalog& catalog,
                                                    const std::string& process,
                                                    const std::string& component);
Result<const ProvidedDescription*> LookUpProvided(const Catalog& catalog,
                                                  const InterfaceName& name);
Result<const RequiredDescription*> LookUpRequired(const Catalog& catalog,
                                                  const InterfaceName& name);

/// A command, or a column of a state table as the read command that it is.
Result<MemberDescription> LookUpCommand(const Catalog& catalog, const Path& path);

/// Whether its caller, or who raises it, has something to say.
[[nodiscard]] bool TakesArgument(const Signature& signature);

/// What a connect makes of a required interface that is connected.
enum class Occupied { kRefused, kReplaced };

/// The order to be given for a connect, checked as far as the catalogue knows. Errors: kInvalid,
/// kNotFound; kIncompatible, as Refusal() words it; kExists where the required interface is
/// connected; kFailed where its process is not there. A provider's process that is not there, or
/// that nobody has seen yet, is all right: the connection will be pending; but it replaces none
/// that is active (kFailed, kNotFound). What a process that is there does not have is not all
/// right.
Result<message::Wiring> PlanConnect(const Catalog& catalog, const message::Wire& wire,
                                    Occupied occupied = Occupied::kRefused);

/// The same order, unchecked.
[[nodiscard]] message::Wiring WiringOf(const Catalog& catalog, const message::Wire& wire);

/// The connection that a disconnect would end. Errors: kInvalid, kNotFound; kFailed where it is not
/// connected or its process is not there.
Result<ConnectionDescription> PlanDisconnect(const Catalog& catalog, const InterfaceName& required);

/// The required interface that `text` names: by its path; or by the number of its connection, "12",
/// or "desk/12" where more than one process has a connection of that number (else kInvalid).
Result<InterfaceName> LookUpConnected(const Catalog& catalog, const std::string& text);

/// New at each start of the process; 0 where there is none of that name.
[[nodiscard]] std::uint64_t InstanceOf(const Catalog& catalog, const std::string& process);

/// Whether the process can be talked to: it is there, if perhaps a little late.
[[nodiscard]] bool IsPresent(const ProcessDescription& process);

/// What the reason of a lost process begins with where nothing came while its link stood.
inline constexpr std::string_view kNoRenewal = "no renewal of its lease for ";

/// Whether the process was lost in silence: its program may be stopped, hang, or be cut off, and
/// come back by itself. One whose link broke has ended.
[[nodiscard]] bool HasFallenSilent(const ProcessDescription& process);

/// What to do where a process is gone: "start it again", or, where it has fallen silent, how to
/// wake or to end its program.
[[nodiscard]] std::string AdviceFor(const ProcessDescription& process);

/// kFailed, "process 'robot' is lost (reason)" or "is starting", unless it is present.
Result<void> RequirePresent(const ProcessDescription& process);

}  // namespace tendon
