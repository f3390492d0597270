#include <tendon/manager/component_registry.h>
#include <tendon/payload/encoded_size.h>
#include <tendon/payload/robot/image.h>
#include <tendon/task/periodic_task.h>

#include <cstdint>
#include <string>
#include <utility>

namespace {

using namespace std::chrono_literals;

/// Records a picture of 6.2 MB and its number ten times per second.
class Camera final : public tendon::PeriodicTask {
 public:
  explicit Camera(std::string name) : PeriodicTask(std::move(name), 100ms) {
    constexpr std::uint32_t kWidth = 1920;
    constexpr std::uint32_t kHeight = 1080;
    image_.width = kWidth;
    image_.height = kHeight;
    image_.step = 3 * kWidth;
    image_.encoding = "rgb8";
    image_.data.assign(std::size_t{image_.step} * kHeight, 200);
    state_table().Add(image_, "Image", tendon::EncodedSize(image_));
    state_table().Add(frame_, "Frame");
  }
  ~Camera() override { Join(); }

 private:
  void Run() override {
    ++image_.data.front();
    ++frame_;
    ProcessQueuedCommands();
  }

  tendon::robot::Image image_;
  std::uint32_t frame_ = 0;
};

}  // namespace

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<Camera>("Camera");
}
