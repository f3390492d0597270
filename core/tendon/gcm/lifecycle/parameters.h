#pragma once

#include <tendon/base/result.h>
#include <tendon/process/lifecycle/lifecycle_messages.h>

#include <string>
#include <vector>

/// Functions for the parameters of a component, as users call the fields of its configuration.
namespace tendon {

/// A field of a configuration that is not itself a structure.
struct Parameter {
  std::string name;    ///< "noise", "gain.x"
  std::string type;    ///< "float64[7]"
  std::string unit;    ///< empty if the parameter has no unit
  std::string values;  ///< the possible values, "0 to 1" or "off, on"; may be empty
  std::string help;    ///< the description from the class; may be empty
  std::string value;   ///< the present value, JSON
};

/// A change of one parameter.
struct ChangedParameter {
  std::string former;         ///< the old value, JSON
  std::string value;          ///< the new value, JSON
  std::string configuration;  ///< the new configuration, JSON
};

/// Returns all parameters of a component of class `of`, in the order of its configuration type.
/// `configuration` is the configuration of the component. Fields with default values may be
/// missing.
Result<std::vector<Parameter>> ParametersOf(const ClassDescription& of,
                                            const std::string& configuration);

/// Returns the parameter with this name ("home"). For a structure ("gain"), returns the parameters
/// inside it. Fails with kNotFound; the error suggests similar names.
Result<std::vector<Parameter>> ParametersAt(const ClassDescription& of,
                                            const std::string& configuration,
                                            const std::string& name);

/// Replaces the value of a parameter, a field or an element, such as "gain.x" or "home[2]". `value`
/// is JSON, but a string or an enumerator needs no quotes. Fails with kNotFound if a part of the
/// name does not exist; the error names that part. Fails with kInvalid if the value is wrong; the
/// error says what was expected and what was found.
Result<ChangedParameter> ChangeParameter(const ClassDescription& of,
                                         const std::string& configuration, const std::string& name,
                                         const std::string& value);

}  // namespace tendon
