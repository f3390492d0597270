#pragma once

#include <tendon/base/result.h>
#include <tendon/process/lifecycle/lifecycle_messages.h>

#include <string>
#include <vector>

/// The fields of a component's configuration, which users call its parameters.
namespace tendon {

/// A field of a configuration that is not itself a structure.
struct Parameter {
  std::string name;    ///< "noise", "gain.x"
  std::string type;    ///< "float64[7]"
  std::string unit;    ///< empty if it has none
  std::string values;  ///< "0 to 1", "off, on": the possible values, or empty
  std::string help;    ///< the description in its class, or empty
  std::string value;   ///< the component's value, JSON
};

/// A change of one parameter.
struct ChangedParameter {
  std::string former;         ///< the old value, JSON
  std::string value;          ///< the new value, JSON
  std::string configuration;  ///< the new configuration, JSON
};

/// All parameters of a component of that class, in the order of the type. `told` is the component's
/// configuration, which may omit fields that keep their default.
Result<std::vector<Parameter>> ParametersOf(const ClassDescription& of, const std::string& told);

/// The parameters at `name` and below it: "home", "gain". kNotFound suggests similar names.
Result<std::vector<Parameter>> ParametersAt(const ClassDescription& of, const std::string& told,
                                            const std::string& name);

/// Replaces the part with this name, "gain.x" or "home[2]", by `value`: JSON, in which a string or
/// an enumerator needs no quotes. kNotFound: the error says which part of the name does not exist.
/// kInvalid: it says what was expected of the value and what was found.
Result<ChangedParameter> ChangeParameter(const ClassDescription& of, const std::string& told,
                                         const std::string& name, const std::string& value);

}  // namespace tendon
