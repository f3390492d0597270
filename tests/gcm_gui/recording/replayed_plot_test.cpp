// The plot of a recording is the plot of what was recorded, also after a replay.

#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/series/shown_time.h>
#include <gcm_gui/plot/shared_time_axis.h>
#include <gcm_gui/theme/theme.h>
#include <gtest/gtest.h>
#include <support/folder.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/middleware/loopback.h>
#include <tendon/payload/numeric_field.h>
#include <tendon/process/process.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/replay.h>
#include <tendon/task/periodic_task.h>

#include <QImage>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/recording/tape.h"
#include "gcm_gui/plot/samples.h"

namespace tendon::gui {

struct Wave {
  std::array<double, 2> angle{};
};

}  // namespace tendon::gui

template <>
inline constexpr auto tendon::kPayload<tendon::gui::Wave> =
    tendon::Describe("plot.Wave", tendon::Field{"angle", &tendon::gui::Wave::angle, "rad"});

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;
using recording::Replay;
using recording::Tape;

const InterfaceName kSource{"robot", "waves", ""};
constexpr std::size_t kCurves = 2;

class Waves final : public PeriodicTask {
 public:
  explicit Waves(std::string name) : PeriodicTask(std::move(name), 1ms) {
    state_table().Add(wave_, "Wave");
  }
  ~Waves() override { Join(); }

  void Run() override {
    const double t = static_cast<double>(++cycle_) / 1000;
    wave_.angle = {std::sin(20 * t), 0.5 * std::tanh(std::sin(9 * t) * 3) + 0.1 * std::sin(90 * t)};
  }

 private:
  std::uint64_t cycle_ = 0;
  Wave wave_;
};

using Samples = std::array<std::vector<Sample>, kCurves>;

/// The samples in a recording, with the times since the first of them.
Samples SamplesIn(const std::filesystem::path& file, mcap::Timestamp mcap::Message::*time_of) {
  Samples samples;
  const auto reader = mcap::Reader::Open(file);
  EXPECT_TRUE(reader) << reader.error().message;
  if (!reader) return samples;
  const auto fields = NumericFields(SchemaOf<Wave>());
  std::int64_t first = 0;
  mcap::MessageStream messages = (*reader)->Messages({.order = mcap::Query::Order::kFile});
  while (const auto message = messages.Next()) {
    if ((*reader)->FindChannel(message->channel_id)->topic != "robot/waves/state/Wave") continue;
    const auto time = static_cast<std::int64_t>(*message.*time_of);
    if (samples[0].empty()) first = time;
    const mcap::ByteView body = message->data.subspan(recording::kEncapsulationSize);
    for (std::size_t i = 0; i < kCurves; ++i) {
      const auto value = ReadAsDouble(fields.at(i), body);
      EXPECT_TRUE(value);
      samples[i].push_back(
          {.time_ns = time - first, .tick = message->sequence, .value = value.value_or(0.0)});
    }
  }
  return samples;
}

/// The plots of all these at the time of the last sample. Time stands still, because axes that move
/// depend on how fast the plots are painted.
std::vector<QImage> PicturesOf(const std::vector<Samples>& recordings) {
  ShowMoment({.steady_ns = recordings.front()[0].back().time_ns, .wall_ns = 0});
  const auto axis = std::make_shared<SharedTimeAxis>();
  std::vector<std::unique_ptr<PlotView>> views;
  for (const Samples& samples : recordings) {
    PlotView& view = *views.emplace_back(std::make_unique<PlotView>(axis));
    ShowView(view);
    view.setWindow(2s);
    for (std::size_t i = 0; i < kCurves; ++i) {
      const QString name = QString("robot/waves/state.Wave.angle[%1]").arg(i);
      view.addCurve({name, "rad"}).append(samples[i]);
    }
    Painted(view);
  }
  std::vector<QImage> pictures;
  for (const auto& view : views) {
    view->refresh();
    view->findChild<QWidget*>("live")->hide();  // it lies over the newest samples
    pictures.push_back(view->grab().toImage());
  }
  ShowPresent();
  return pictures;
}

TEST(ReplayedPlot, ARecordingOfAReplayIsTheSamePictureAsTheRecording) {
  const test::Folder folder;
  const auto network = std::make_shared<LoopbackNetwork>();
  const auto node = [&] { return std::make_shared<LoopbackMiddleware>(network); };
  const auto gcm = GlobalManager::Start(
      node(), {.address = "127.0.0.1:0", .state_folder = folder.path() / "gcm"});
  ASSERT_TRUE(gcm) << gcm.error().message;
  const std::string address = (*gcm)->address();
  const auto process = [&](const std::string& name) {
    return std::make_unique<Process>(name, ProcessOptions{.middleware = node(), .gcm = address});
  };
  const std::filesystem::path first = folder.path() / "first.mcap";
  const std::filesystem::path second = folder.path() / "second.mcap";
  {
    const auto robot = process("robot");
    robot->Add<Waves>("waves");
    ASSERT_TRUE(robot->StartAll());
    Tape tape(node(), address, first, kSource);
    ASSERT_TRUE(EventuallyTrue([&] { return tape.Write().rows >= 1500; }));
    tape.Close();
  }
  {
    auto replay = Replay::Open(*mcap::Reader::Open(first), {}, {});
    ASSERT_TRUE(replay) << replay.error().message;
    ASSERT_TRUE((*replay)->Start(
        [&](const std::string& name) { return Result<std::unique_ptr<Process>>(process(name)); }));
    ASSERT_TRUE((*replay)->WaitUntilJoined(30s));
    Tape tape(node(), address, second, kSource);
    SteadyTime now = SteadyClock().Now();
    const auto is_taken = [&] { return tape.Write().rows == (*replay)->status().rows; };
    for (int i = 0; const auto next = (*replay)->Play(now); ++i) {
      now = *next;
      if (i % 50 == 49) ASSERT_TRUE(EventuallyTrue(is_taken));
    }
    ASSERT_TRUE(EventuallyTrue(is_taken));
    tape.Close();
  }

  Theme::instance().choose(Theme::Choice::kDark);
  // The source of the replay writes its rows at the log times of the recording.
  const Samples recorded = SamplesIn(first, &mcap::Message::log_time);
  const Samples replayed = SamplesIn(second, &mcap::Message::publish_time);
  Samples other = recorded;
  other[1].at(700).value = 1.5;
  ASSERT_GE(recorded[0].size(), 1500U);
  const auto pictures = PicturesOf({recorded, replayed, other});

  EXPECT_EQ(recorded[0].size(), replayed[0].size());
  EXPECT_EQ(pictures[0], pictures[1]);
  EXPECT_NE(pictures[0], pictures[2]) << "one other value is seen";
  KeepPicture(pictures[0], "recorded");
  KeepPicture(pictures[1], "replayed");
}

}  // namespace
}  // namespace tendon::gui
