#pragma once

#include <tendon/process/context.h>

#include <mutex>
#include <string>

/// A process without components.
class EmptyProcess : public tendon::ProcessAccess {
 public:
  using Lock = std::unique_lock<std::recursive_mutex>;

  [[nodiscard]] Lock LockStructure() const override { return Lock(mutex_); }
  [[nodiscard]] tendon::Result<tendon::RequiredInterface*> LookUpRequired(
      const tendon::InterfaceName& /*name*/) const override {
    return Nothing();
  }
  [[nodiscard]] tendon::Result<tendon::ProvidedInterface*> LookUpProvided(
      const tendon::InterfaceName& /*name*/) const override {
    return Nothing();
  }
  [[nodiscard]] tendon::Component* LookUpComponent(const std::string& /*name*/) const override {
    return nullptr;
  }
  [[nodiscard]] tendon::Result<tendon::ConnectionCounts> LookUpCounts(
      const tendon::InterfaceName& /*name*/) const override {
    return Nothing();
  }
  [[nodiscard]] tendon::Result<tendon::MailboxFill> LookUpFill(
      const std::string& /*component*/) const override {
    return Nothing();
  }
  tendon::ConnectionId NewConnectionId() override { return {}; }
  void StructureChanged() const override {}

 protected:
  static tendon::Error Nothing() { return {tendon::ErrorCode::kNotFound, "there is nothing"}; }

 private:
  mutable std::recursive_mutex mutex_;
};
