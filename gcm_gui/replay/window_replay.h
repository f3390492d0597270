#pragma once

#include <QObject>
#include <QTimer>
#include <cstdint>

namespace tendon::gui {

class Commands;
class PlotPanel;
class RecordingNotes;
class ReplaySession;
class ReplayStrip;

/// Connects a recording with the window that shows it: the strip, the keys, the plots, and the
/// user's notes about the file.
class WindowReplay : public QObject {
  Q_OBJECT

 public:
  /// All arguments must outlive this object. The caller places the strip and owns it.
  WindowReplay(ReplaySession& session, RecordingNotes& notes, QObject* parent);
  ~WindowReplay() override;

  [[nodiscard]] ReplaySession& session() const { return session_; }
  [[nodiscard]] ReplayStrip& strip() const { return *strip_; }
  void setPlots(PlotPanel& plots);
  void addCommands(Commands& commands);

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  void keep();
  void showMoment();
  [[nodiscard]] std::int64_t pastInSight() const;

  ReplaySession& session_;
  RecordingNotes& notes_;
  ReplayStrip* strip_;
  PlotPanel* plots_ = nullptr;
  QTimer past_timer_;
  bool is_known_ = false;  // the notes about this file were read
};

}  // namespace tendon::gui
