#include <benchmarks/remote/pipeline.h>
#include <benchmarks/remote/remote_system.h>

#include <memory>
#include <thread>
#include <utility>

namespace tendon::benchmark {
namespace {

constexpr std::uint64_t kBatch = 100;
constexpr std::uint64_t kWindow = 64;

// The numbers of operations are chosen such that a repetition keeps the processor busy for about 10
// ms. The kernel allows real-time threads only 95 % of the processor time.

using Run = std::function<double(RemoteSystem&)>;

/// Returns the time of one operation. `work` does all `times` operations.
template <typename Work>
double NanosecondsEachOf(std::uint64_t times, Work work) {
  return NanosecondsEach(1, [&](std::uint64_t) { work(); }) / static_cast<double>(times);
}

double ReadRaw(RawIce& raw, std::uint64_t reads) {
  Message joints{};
  return NanosecondsEach(reads, [&](std::uint64_t) {
    raw.Read(joints);
    Use(joints);
  });
}

/// Reads each image into the same object, as a component does.
double ReadImages(Desk& desk, ReadFunction<Image> Desk::*get, std::uint64_t images) {
  return NanosecondsEach(images, [&](std::uint64_t) {
    const bool is_read = static_cast<bool>((desk.*get)(desk.image));
    Require(is_read && desk.image.size() * sizeof(double) == kImageBytes, "no image is read");
  });
}

double ReadRawImages(RawIce& raw, std::uint64_t images, RawIce::Image image) {
  return NanosecondsEach(images, [&](std::uint64_t) {
    Require(raw.ReadImage(image) > kImageBytes, "no image is read");
  });
}

double MoveAndWait(RemoteSystem& system, std::uint64_t moves) {
  Argument goal{};
  return NanosecondsEach(moves, [&](std::uint64_t i) {
    goal[0] = static_cast<double>(i);
    Require(static_cast<bool>(system.desk().move.Wait(goal, kTestTimeout)),
            "the robot does not move");
  });
}

/// Returns when the robot has executed all moves. Yields the processor if the mailbox is full, and
/// after the calls of each tick.
double Move(RemoteSystem& system, std::uint64_t moves, std::uint64_t per_tick) {
  Argument goal{};
  return NanosecondsEachOf(moves, [&] {
    for (std::uint64_t i = 1; i < moves; ++i) {
      goal[0] = static_cast<double>(i);
      while (!system.desk().move(goal)) std::this_thread::yield();
      if (i % per_tick == 0) std::this_thread::yield();
    }
    Require(static_cast<bool>(system.desk().move.Wait(goal, kTestTimeout)),
            "the robot does not move");
  });
}

/// Writes with raw Ice, with `per_message` writes in each message.
double WriteRaw(RawIce& raw, std::uint64_t writes, std::uint64_t per_message) {
  const Argument goal{};
  const auto bytes = std::as_bytes(std::span(goal));
  return NanosecondsEachOf(writes, [&] {
    if (per_message == 1) return raw.Write(bytes, writes);
    raw.WriteBatches(bytes, writes, per_message);
  });
}

std::vector<Case> ReadCases(const Effort& effort, const TheSystem& system) {
  const std::uint64_t reads = effort.Times(200);
  const std::uint64_t images = effort.Times(8);
  const auto between = [&](const Run& run) { return Between(system, run); };
  const auto read = between([=](auto& both) { return ReadJoints(both, reads); });
  const auto raw_images = [=](RawIce::Image image) {
    return between([=](auto& both) { return ReadRawImages(both.raw(), images, image); });
  };
  return {
      {.id = "R1",
       .what = "remote read / raw Ice two-way, 64 B",
       .gate = 1.10,
       .stretch = 1.05,
       .repetition =
           SideBySide(read, between([=](auto& both) { return ReadRaw(both.raw(), reads); }))},
      {.id = "R1-one",
       .what = "the same / raw Ice that one thread dispatches",
       .repetition = SideBySide(
           read, between([=](auto& both) { return ReadRaw(both.raw_of_one_thread(), reads); }))},
      {.id = "R7",
       .what = "read of 1 MiB that is shared / raw Ice two-way, 1 MiB",
       .ratio = Ratio::kOfThroughputs,
       .gate = 0.85,
       .stretch = 0.95,
       .repetition = SideBySide(between([=](auto& both) {
                                  return ReadImages(both.desk(), &Desk::get_shared_image, images);
                                }),
                                raw_images(RawIce::Image::kThere))},
      {.id = "R7-filled",
       .what = "read of 1 MiB that is copied first / raw Ice that copies it first",
       .ratio = Ratio::kOfThroughputs,
       .gate = 0.85,
       .stretch = 0.95,
       .repetition = SideBySide(
           between([=](auto& both) { return ReadImages(both.desk(), &Desk::get_image, images); }),
           raw_images(RawIce::Image::kCopiedFirst))},
      {.id = "R7-copy",
       .what = "the same / raw Ice that copies nothing",
       .ratio = Ratio::kOfThroughputs,
       .repetition = SideBySide(
           between([=](auto& both) { return ReadImages(both.desk(), &Desk::get_image, images); }),
           raw_images(RawIce::Image::kThere))},
  };
}

std::vector<Case> WriteCases(const Effort& effort, const TheSystem& system) {
  const std::uint64_t writes = effort.Times(2'000);
  const auto side_by_side = [&](const Run& ours, const Run& floor) {
    return SideBySide(Between(system, ours), Between(system, floor));
  };
  return {
      {.id = "R3",
       .what = "remote queued write, 56 B / raw Ice oneway",
       .ratio = Ratio::kOfThroughputs,
       .gate = 0.85,
       .stretch = 0.95,
       .repetition = side_by_side([=](auto& both) { return Move(both, writes, writes); },
                                  [=](auto& both) { return WriteRaw(both.raw(), writes, 1); })},
      {.id = "R4",
       .what = "the same, 100 a tick / raw Ice batch of 100",
       .ratio = Ratio::kOfThroughputs,
       .gate = 0.6,
       .stretch = 0.85,
       .repetition =
           side_by_side([=](auto& both) { return Move(both, writes, kBatch); },
                        [=](auto& both) { return WriteRaw(both.raw(), writes, kBatch); })},
  };
}

std::vector<Case> WaitingCallCases(const Effort& effort, const TheSystem& system) {
  const std::uint64_t alone = effort.Times(150);
  const std::uint64_t many = effort.Times(500);
  const auto side_by_side = [&](const Run& ours, const Run& floor) {
    return SideBySide(Between(system, ours), Between(system, floor));
  };
  const auto waiting_calls = std::make_shared<std::unique_ptr<WaitingCalls>>();
  return {
      {.id = "R2",
       .what = "remote waiting command / Ice two-way + futex",
       .gate = 1.15,
       .stretch = 1.05,
       .repetition = side_by_side(
           [=](auto& both) { return MoveAndWait(both, alone); },
           [=](auto& both) { return ReadRaw(both.raw(), alone) + WakeInTurns(alone); })},
      {.id = "R5",
       .what = "waiting commands, 64 at a time / Ice asynchronous",
       .ratio = Ratio::kOfThroughputs,
       .gate = 0.85,
       .stretch = 0.95,
       .repetition = side_by_side(
           [=](auto& both) {
             if (!*waiting_calls) *waiting_calls = std::make_unique<WaitingCalls>(both, kWindow);
             return NanosecondsEachOf(many, [&] { (*waiting_calls)->Run(many); });
           },
           [=](auto& both) {
             return NanosecondsEachOf(many, [&] {
               RunPipeline(many, kWindow, [&](auto done) { both.raw().BeginRead(done); });
             });
           })},
  };
}

}  // namespace

double ReadJoints(RemoteSystem& system, std::uint64_t reads) {
  Message joints{};
  return NanosecondsEach(reads, [&](std::uint64_t) {
    Require(static_cast<bool>(system.desk().get_joints(joints)), "the robot is not read");
    Use(joints);
  });
}

std::vector<Case> RemoteCases(const Effort& effort, const TheSystem& system) {
  std::vector<Case> all;
  for (const auto& make : {ReadCases, WriteCases, WaitingCallCases}) {
    for (Case& one : make(effort, system)) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace tendon::benchmark
