#include <gcm_console/verbs/configured_component.h>

#include <tendon/gcm/lookup.h>

#include <algorithm>

namespace console {

using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;
using tendon::message::Classes;

Result<ConfiguredComponent> FindConfigured(tendon::GcmClient& client,
                                           std::chrono::milliseconds timeout,
                                           const tendon::Path& path) {
  const tendon::Catalogue catalogue = client.catalogue();
  const auto component = LookUpComponent(catalogue, path.process, path.component);
  if (!component) return component.error();
  const tendon::ComponentDescription& known = **component;
  if (known.class_name.empty()) {
    return Error{ErrorCode::kFailed, "component '" + path.component +
                                         "' was created by the program of process '" +
                                         path.process +
                                         "' itself, not from a class: its parameters cannot be "
                                         "set remotely"};
  }
  const auto all = tendon::Wait<Classes>(
      timeout, [&](auto handler) { client.GetClasses(path.process, std::move(handler)); });
  if (!all) return all.error();
  const auto of = std::ranges::find_if(all->classes, [&](const tendon::ClassDescription& one) {
    return one.name == known.class_name && one.library == known.library;
  });
  if (of == all->classes.end()) {
    return Error{ErrorCode::kFailed, "process '" + path.process +
                                         "' does not report the configuration of class '" +
                                         known.class_name + "'"};
  }
  return ConfiguredComponent{*of, known.configuration, InstanceOf(catalogue, path.process)};
}

}  // namespace console
