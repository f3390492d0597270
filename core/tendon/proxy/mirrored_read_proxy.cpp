#include <tendon/base/clock.h>
#include <tendon/proxy/mirrored_read_proxy.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

namespace tendon {
namespace {

class MirroredReadCommand final : public CommandBase {
 public:
  explicit MirroredReadCommand(std::shared_ptr<const MirroredValue> value)
      : CommandBase(layout::kNone, layout::kNone), value_(std::move(value)) {}

  Status ExecuteEncoded(std::span<const std::byte> /*in*/, AnswerSink& out) override {
    Scratch<std::vector<std::byte>>::Use value(read_);
    SteadyTime written;
    const Status status = value_->Read(*value, written);
    if (status) {
      written_.Set(written.time_since_epoch());
      out.Take(*value);
    }
    return status;
  }

  [[nodiscard]] std::chrono::nanoseconds age() const override {
    const std::chrono::nanoseconds written = written_.Get();
    if (written == kNever || value_->has_ended()) return kNever;
    // The clock of another host may seem to be ahead.
    const auto now = SteadyClock().Now().time_since_epoch();
    return std::max(now - written, std::chrono::nanoseconds(0));
  }

 private:
  static constexpr std::chrono::nanoseconds kNever = std::chrono::nanoseconds::max();

  const std::shared_ptr<const MirroredValue> value_;
  Scratch<std::vector<std::byte>> read_;
  Published<std::chrono::nanoseconds> written_{kNever};  // time of the value that was read last
};

}  // namespace

std::unique_ptr<CommandBase> MirroredReadProxy::Bind(Mailbox* /*mailbox*/) const {
  return std::make_unique<MirroredReadCommand>(value_);
}

}  // namespace tendon
