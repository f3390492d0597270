#pragma once

#include <tendon/base/result.h>
#include <tendon/process/life/messages.h>

#include <string>
#include <vector>

/// The configuration of a component, field by field: what people call its parameters.
namespace tendon {

/// A field of a configuration that is no structure itself.
struct Parameter {
  std::string name;    ///< "noise", "gain.x"
  std::string type;    ///< "float64[7]"
  std::string unit;    ///< empty where it has none
  std::string values;  ///< "0 to 1", "off, on": what it can be, or empty
  std::string help;    ///< what its class says of it, or empty
  std::string value;   ///< JSON, as the component has it
};

/// One parameter, changed.
struct ChangedParameter {
  std::string former;         ///< its value so far, JSON
  std::string value;          ///< its value then, JSON
  std::string configuration;  ///< what the component is to be told then, JSON
};

/// All parameters of a component of that class, in the order of the type. `told` is the
/// configuration it was given, which may leave out what keeps its default.
Result<std::vector<Parameter>> ParametersOf(const ClassDescription& of, const std::string& told);

/// Those at `name` and below it: "home", "gain". kNotFound names what is near.
Result<std::vector<Parameter>> ParametersAt(const ClassDescription& of, const std::string& told,
                                            const std::string& name);

/// Replaces the part that `name` names, "gain.x" or "home[2]", by `value`: JSON, where a text or
/// the name of an enumerator needs no quotes. kNotFound says where the name leaves the
/// configuration; kInvalid what was expected of the value and what was found.
Result<ChangedParameter> ChangeParameter(const ClassDescription& of, const std::string& told,
                                         const std::string& name, const std::string& value);

}  // namespace tendon
