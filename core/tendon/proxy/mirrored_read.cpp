#include <tendon/proxy/mirrored_read.h>

#include <tendon/base/clock.h>
#include <tendon/state/cell.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <vector>

namespace tendon {
namespace {

constexpr std::size_t kWord = sizeof(std::uint64_t);
constexpr std::size_t kCopies = 3;  // readers can use older copies while the next one is written

std::size_t WordsFor(std::size_t bytes) { return 1 + (bytes + kWord - 1) / kWord; }

class MirroredReadCommand final : public CommandBase {
 public:
  explicit MirroredReadCommand(std::shared_ptr<const MirroredValue> value)
      : CommandBase(layout::kNone, layout::kNone), value_(std::move(value)) {}

  Status ExecuteEncoded(std::span<const std::byte> /*in*/, ReplySink& out) override {
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
    // The time of another host may be slightly in the future.
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

MirroredValue::MirroredValue(std::size_t capacity)
    : capacity_(capacity), words_(WordsFor(capacity)) {
  copies_.Allocate(kCopies, words_.size());
}

bool MirroredValue::Put(SteadyTime time, std::span<const std::byte> body) {
  if (body.size() > capacity_) return false;
  words_.front() = body.size();
  if (!body.empty()) std::memcpy(&words_[1], body.data(), body.size());
  copies_.Begin(time.time_since_epoch().count());
  copies_.Store(0, std::span(words_).first(WordsFor(body.size())));
  copies_.Publish();
  return true;
}

Status MirroredValue::Read(std::vector<std::byte>& body, SteadyTime& time) const {
  if (has_ended_.Get()) return Status::kNotConnected;
  if (!is_enabled_.Get()) return Status::kDisabled;
  std::uint64_t tick = 0;
  const RowResult result = copies_.ReadNewest(tick, [&](const RowRing<>::Word* words) {
    std::array<std::byte, kWord> word{};
    LoadWord(words[0], word.data());
    // The size may be any number, because a newer copy may overwrite this copy during the read.
    const auto size = std::bit_cast<std::uint64_t>(word);
    body.resize(std::min<std::uint64_t>(size, capacity_));
    for (std::size_t at = 0; at < body.size(); at += kWord) {
      LoadWord(words[1 + at / kWord], word.data());
      std::memcpy(body.data() + at, word.data(), std::min(kWord, body.size() - at));
    }
    time = SteadyTime(std::chrono::nanoseconds(RowRing<>::TimeOf(words)));
  });
  return result == RowResult::kDone && !body.empty() ? Status::kDone : Status::kNoSample;
}

std::unique_ptr<CommandBase> MirroredReadProxy::Bind(Mailbox* /*mailbox*/) const {
  return std::make_unique<MirroredReadCommand>(value_);
}

}  // namespace tendon
