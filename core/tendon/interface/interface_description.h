#pragma once

#include <tendon/interface/signature.h>

#include <string>
#include <vector>

namespace tendon {

/// One member of an interface: a command, an event, a function (which needs a command) or a handler
/// (which needs an event). The names of the payload types are only for people. The signature alone
/// decides whether two members fit.
struct MemberDescription {
  std::string name;
  Signature signature;
  std::string in_type;
  std::string out_type;
  bool optional = false;  ///< functions and handlers: not needed for a connection
  std::string hazard;     ///< for commands: "motion" if a call can move something
  /// For commands, in seconds. The effect of a call ends if no other call renews it within this
  /// time. 0 means that the effect does not end.
  double expires_after = 0.0;

  bool operator==(const MemberDescription&) const = default;
};

/// The members that a component offers under one name. `events` are of kind void or write.
struct ProvidedDescription {
  std::string name;
  std::vector<MemberDescription> commands;
  std::vector<MemberDescription> events;

  bool operator==(const ProvidedDescription&) const = default;
};

/// The functions and handlers for which a component needs a peer, under one name.
struct RequiredDescription {
  std::string name;
  std::vector<MemberDescription> functions;
  std::vector<MemberDescription> event_handlers;
  bool optional = false;

  bool operator==(const RequiredDescription&) const = default;
};

template <>
inline constexpr auto kPayload<MemberDescription> = Describe(
    "tendon.MemberDescription", Field{"name", &MemberDescription::name},
    Field{"signature", &MemberDescription::signature},
    Field{"in_type", &MemberDescription::in_type}, Field{"out_type", &MemberDescription::out_type},
    Field{"optional", &MemberDescription::optional}, Field{"hazard", &MemberDescription::hazard},
    Field{"expires_after", &MemberDescription::expires_after, "s"});

template <>
inline constexpr auto kPayload<ProvidedDescription> =
    Describe("tendon.ProvidedDescription", Field{"name", &ProvidedDescription::name},
             Field{"commands", &ProvidedDescription::commands},
             Field{"events", &ProvidedDescription::events});

template <>
inline constexpr auto kPayload<RequiredDescription> =
    Describe("tendon.RequiredDescription", Field{"name", &RequiredDescription::name},
             Field{"functions", &RequiredDescription::functions},
             Field{"event_handlers", &RequiredDescription::event_handlers},
             Field{"optional", &RequiredDescription::optional});

}  // namespace tendon
