#pragma once

#include <components/host_monitor/host_payloads.h>

#include <filesystem>
#include <string>
#include <vector>

namespace host {

/// Returns the content of a small file; empty if the file cannot be read.
[[nodiscard]] std::string ReadText(const std::filesystem::path& file);

/// The thermometers of a machine. They are found once, and then read repeatedly.
class Thermometers {
 public:
  /// Searches below `root`/sys: thermal zones first, then monitoring chips.
  explicit Thermometers(const std::filesystem::path& root);

  [[nodiscard]] bool empty() const { return files_.empty(); }
  /// Writes one entry per thermometer to `temperatures`, always in the same order.
  void Read(Temperatures& temperatures) const;

 private:
  struct File {
    std::string sensor;
    std::filesystem::path path;
  };
  void Add(std::string sensor, const std::filesystem::path& path);

  std::vector<File> files_;
};

}  // namespace host
