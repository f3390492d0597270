#include "replay/stoppable_disk.h"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <span>
#include <string>
#include <utility>

namespace tendon::gui {
namespace {

using Opened = Result<std::unique_ptr<os::RandomAccessFile>>;

}  // namespace

struct StoppableDisk::State {
  void waitUntilItGoes(std::unique_lock<std::mutex>& lock) {
    ++counts.waiting;
    goes.wait(lock, [this] { return !is_stopped; });
    --counts.waiting;
  }

  std::mutex mutex;
  std::condition_variable goes;
  bool is_stopped = false;  // guarded by mutex, as is the next member
  Counts counts;
};

class StoppableDisk::File final : public os::RandomAccessFile {
 public:
  File(std::shared_ptr<State> state, std::unique_ptr<os::RandomAccessFile> file)
      : state_(std::move(state)), file_(std::move(file)) {
    const std::lock_guard lock(state_->mutex);
    ++state_->counts.open_files;
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() override {
    std::unique_lock lock(state_->mutex);
    state_->waitUntilItGoes(lock);
    --state_->counts.open_files;
  }

  [[nodiscard]] const std::string& name() const noexcept override { return file_->name(); }
  [[nodiscard]] std::uint64_t size() const noexcept override { return file_->size(); }
  Result<void> ReadAt(std::uint64_t offset, std::span<std::byte> bytes) override {
    std::unique_lock lock(state_->mutex);
    ++state_->counts.reads;
    state_->waitUntilItGoes(lock);
    lock.unlock();
    return file_->ReadAt(offset, bytes);
  }
  [[nodiscard]] bool is_being_written() const noexcept override {
    return file_->is_being_written();
  }

 private:
  const std::shared_ptr<State> state_;
  const std::unique_ptr<os::RandomAccessFile> file_;
};

StoppableDisk::StoppableDisk() : state_(std::make_shared<State>()) {}

StoppableDisk::~StoppableDisk() { go(); }

void StoppableDisk::stop() {
  const std::lock_guard lock(state_->mutex);
  state_->is_stopped = true;
}

void StoppableDisk::go() {
  const std::lock_guard lock(state_->mutex);
  state_->is_stopped = false;
  state_->goes.notify_all();
}

StoppableDisk::Counts StoppableDisk::counts() const {
  const std::lock_guard lock(state_->mutex);
  return state_->counts;
}

ReplayReader::OpenFile StoppableDisk::opener() const {
  return [state = state_](const std::filesystem::path& name) -> Opened {
    auto file = os::OpenRandomAccessFile(name);
    if (!file) return file.error();
    return Opened(std::make_unique<File>(state, *std::move(file)));
  };
}

}  // namespace tendon::gui
