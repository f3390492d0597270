#pragma once

#include <gcm_gui/replay/replay_reader.h>

#include <memory>

namespace tendon::gui {

/// The real disk, which a test can stop: then each read and each closing of a file waits until the
/// disk goes again.
///
/// Thread safety: any thread.
class StoppableDisk {
 public:
  /// A count of all files that were opened by opener().
  struct Counts {
    int open_files = 0;
    int reads = 0;    ///< that have begun
    int waiting = 0;  ///< reads and closings that wait
  };

  StoppableDisk();
  StoppableDisk(const StoppableDisk&) = delete;
  StoppableDisk& operator=(const StoppableDisk&) = delete;
  /// Calls go().
  ~StoppableDisk();

  void stop();
  void go();
  [[nodiscard]] Counts counts() const;
  /// The opened files can outlive the disk.
  [[nodiscard]] ReplayReader::OpenFile opener() const;

 private:
  struct State;
  class File;

  std::shared_ptr<State> state_;
};

}  // namespace tendon::gui
