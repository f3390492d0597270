#include <tendon/manager/plugin_files.h>

#include <utility>

namespace tendon {
namespace {

PluginState StateOf(os::FileWatch::State state) {
  switch (state) {
    case os::FileWatch::State::kSame:
      return PluginState::kCurrent;
    case os::FileWatch::State::kOther:
      return PluginState::kChanged;
    case os::FileWatch::State::kGone:
      break;
  }
  return PluginState::kGone;
}

}  // namespace

void PluginFiles::Add(const std::string& library, os::FileContent content) {
  {
    const std::scoped_lock lock(update_mutex_);
    loaded_.push_back({library, os::FileWatch(std::move(content))});
  }
  Update();
}

void PluginFiles::Update() {
  const std::scoped_lock look(update_mutex_);
  std::vector<PluginDescription> now;
  for (LoadedPlugin& one : loaded_) now.push_back(Describe(one));
  const std::scoped_lock lock(mutex_);
  if (now == descriptions_) return;
  descriptions_ = std::move(now);
  ++revision_;
}

std::uint64_t PluginFiles::revision() const {
  const std::scoped_lock lock(mutex_);
  return revision_;
}

std::vector<PluginDescription> PluginFiles::descriptions() const {
  const std::scoped_lock lock(mutex_);
  return descriptions_;
}

PluginDescription PluginFiles::Describe(LoadedPlugin& loaded) {
  const PluginState state = StateOf(loaded.file.Check());
  const os::FileContent& content = loaded.file.content();
  return {.name = loaded.library,
          .file = content.file.string(),
          .written = content.stamp.written,
          .state = state,
          .written_now = state == PluginState::kChanged ? loaded.file.written_now() : 0};
}

}  // namespace tendon
