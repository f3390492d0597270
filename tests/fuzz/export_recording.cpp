#include "export_recording.h"

#include <support/memory_file.h>
#include <tendon/base/os/process.h>
#include <tendon/recording/csv_export.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "promise.h"
#include "read_recording.h"

namespace fuzz {
namespace {

namespace fs = std::filesystem;
namespace mcap = tendon::mcap;
using tendon::recording::CsvReport;

/// What a reader of CSV finds in a file: the cells of each line.
std::vector<std::vector<std::string>> ReadCsv(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::vector<std::vector<std::string>> lines;
  std::string cell;
  bool is_quoted = false;
  std::vector<std::string> line;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (is_quoted && letter == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      cell += text[++i];
    } else if (letter == '"') {
      is_quoted = !is_quoted;
    } else if (!is_quoted && (letter == ',' || letter == '\n')) {
      line.push_back(std::exchange(cell, {}));
      if (letter == '\n') lines.push_back(std::exchange(line, {}));
    } else {
      cell += letter;
    }
  }
  Require(!is_quoted && cell.empty() && line.empty(), "a CSV file ends with a line");
  return lines;
}

std::uint64_t CountMessages(mcap::Reader& reader) {
  std::uint64_t count = 0;
  mcap::MessageStream messages = reader.Messages({.order = mcap::Query::Order::kFile});
  while (messages.Next()) ++count;
  return count;
}

void CheckFiles(const CsvReport& report) {
  std::uint64_t lost = 0;
  std::uint64_t lines = 0;
  for (const fs::path& file : report.files) {
    const auto all = ReadCsv(file);
    Require(!all.empty(), "a CSV file has titles");
    for (std::size_t i = 1; i < all.size(); ++i) {
      Require(all[i].size() == all[0].size(), "a line has a cell for each title");
      const std::uint64_t missing = std::stoull(all[i][3]);
      missing > 0 ? lost += missing : ++lines;
    }
  }
  Require(lost == report.lost, "the file has the losses that the report counts");
  Require(lines == report.rows + report.events + report.log + report.others,
          "the file has the lines that the report counts");
}

}  // namespace

std::unique_ptr<mcap::Reader> OpenRecording(Bytes bytes) {
  auto reader = mcap::Reader::Open(std::make_unique<tendon::test::MemoryFile>(
                                       std::vector<std::byte>(bytes.begin(), bytes.end())),
                                   kSmallLimits);
  return reader ? *std::move(reader) : nullptr;
}

fs::path ExportPath() {
  const fs::path memory = "/dev/shm";
  std::error_code ignored;
  const fs::path folder = fs::is_directory(memory, ignored) ? memory : fs::temp_directory_path();
  return folder / ("tendon-fuzz-" + std::to_string(tendon::os::ProcessId()));
}

void ExportAsCsv(Bytes bytes) {
  const auto reader = OpenRecording(bytes);
  if (!reader) return;
  const fs::path folder = ExportPath();
  const auto report = tendon::recording::ExportCsv(*reader, {}, folder);
  if (report) {
    CheckFiles(*report);
    std::uint64_t left_out = 0;
    for (const auto& [reason, count] : report->left_out) left_out += count;
    Require(report->events + report->log + report->others + left_out <= CountMessages(*reader),
            "no message is exported twice");
    for (const auto& file : fs::directory_iterator(folder)) {
      Require(file.path().extension() == ".csv", "no part of a file is left");
    }
  } else {
    Require(!fs::exists(folder), "a refused export leaves nothing");
  }
  fs::remove_all(folder);
}

}  // namespace fuzz
