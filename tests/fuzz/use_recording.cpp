#include "use_recording.h"

#include <tendon/middleware/loopback.h>
#include <tendon/process/process.h>
#include <tendon/recording/hdf5/hdf5_export.h>
#include <tendon/recording/replay.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "export_recording.h"
#include "promise.h"

namespace fuzz {
namespace {

namespace fs = std::filesystem;
namespace mcap = tendon::mcap;
using tendon::Process;
using tendon::Result;
using tendon::recording::RecordingReader;

/// The items that a replay will play: in order, complete, and the same again.
void ReadItems(mcap::Reader& reader) {
  const auto items = RecordingReader::Open(reader, {});
  if (!items) return;
  std::map<std::size_t, std::uint64_t> ticks;  // the last one, by source
  std::uint64_t rows = 0;
  std::uint64_t others = 0;
  mcap::Timestamp last = 0;
  while (const auto item = (*items)->Next()) {
    Require(item->time >= last || reader.problems().count() > 0, "items are in order of time");
    last = item->time;
    const auto* row = std::get_if<tendon::recording::RecordedRow>(&item->content);
    if (row == nullptr) {
      ++others;
      continue;
    }
    ++rows;
    const auto& source = (*items)->sources().at(item->source);
    Require(row->cells.size() == source.members.size(), "a row has a cell for each column");
    for (std::size_t i = 0; i < row->cells.size(); ++i) {
      Require(row->cells[i].size() <= source.members[i].largest, "a cell fits its column");
    }
    const auto [known, is_new] = ticks.try_emplace(item->source, row->tick);
    Require(is_new || row->tick > known->second, "ticks only grow");
    known->second = row->tick;
  }
  const auto& counts = (*items)->counts();
  Require(rows == counts.rows && others == counts.events + counts.log,
          "each pass has the same items");
}

}  // namespace

void ReplayRecording(Bytes bytes) {
  auto reader = OpenRecording(bytes);
  if (!reader) return;
  ReadItems(*reader);
  auto replay = tendon::recording::Replay::Open(std::move(reader), {}, {.rate = 1000.0});
  constexpr std::size_t kMaxProcesses = 2;  // each has six threads
  if (!replay || (*replay)->processes().size() > kMaxProcesses) return;
  const auto network = std::make_shared<tendon::LoopbackNetwork>();
  const auto started =
      (*replay)->Start([&](const std::string& name) -> Result<std::unique_ptr<Process>> {
        try {
          return std::make_unique<Process>(
              name, tendon::ProcessOptions{
                        .middleware = std::make_shared<tendon::LoopbackMiddleware>(network)});
        } catch (const tendon::ConfigurationError& error) {
          return tendon::Error{error.code(), error.what()};
        }
      });
  if (!started) return;
  tendon::SteadyTime now = tendon::SteadyClock().Now();
  while (const auto next = (*replay)->Play(now)) now = std::max(now, *next);
  Require((*replay)->status().rows == (*replay)->contained().rows, "a replay has all rows");
  Require((*replay)->status().events == (*replay)->contained().events, "a replay has all events");
  Require((*replay)->HasSentAll(), "a replay that nobody watches has nothing to send");
}

void ExportAsHdf5(Bytes bytes) {
  const auto reader = OpenRecording(bytes);
  if (!reader) return;
  const fs::path file = ExportPath();
  const auto report = tendon::recording::ExportHdf5(*reader, {}, file);
  Require(report.ok() == fs::exists(file), "a file is there if the export says so");
  Require(!fs::exists(file.string() + ".part"), "no part of a file is left");
  fs::remove(file);
}

}  // namespace fuzz
