#pragma once

#include <benchmarks/remote/raw_ice.h>
#include <benchmarks/wiring.h>
#include <tendon/task/signal_task.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tendon::benchmark {

using Image = std::vector<double>;  // an image of kImageBytes

/// The component that is called from another process. Sleeps until a call arrives.
class Robot final : public SignalTask {
 public:
  /// The number of rows that "state-History" keeps.
  static constexpr std::size_t kRows = 100'000;

  explicit Robot(std::string name);
  ~Robot() override { Join(); }

 private:
  void Run() override { ProcessQueuedCommands(); }
  void Move(const Argument& goal) { goal_ = goal; }
  void Record(const std::uint64_t& rows);
  void GetImage(Image& image) const { image = *image_; }
  [[nodiscard]] std::shared_ptr<const Image> shared_image() const { return image_; }

  Argument goal_{};
  Message joints_{};
  Argument row_{};
  const std::shared_ptr<const Image> image_ =
      std::make_shared<const Image>(kImageBytes / sizeof(double));
  StateTable& history_;
};

/// The client of the robot.
class Desk final : public Component {
 public:
  explicit Desk(std::string name);

  WriteFunction<Argument> move;
  WriteFunction<std::uint64_t> record;
  ReadFunction<Message> get_joints;
  ReadFunction<Image> get_image;
  ReadFunction<Image> get_shared_image;

  Image image;  ///< the image that was read last
};

}  // namespace tendon::benchmark
