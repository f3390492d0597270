#include <tendon/process/telemetry/row_viewers.h>

#include <tendon/process/viewer_messages.h>

namespace tendon {

void ReportEnd(const RowViewer& viewer, const Error& reason) {
  const Status sent =
      viewer.channel->Notify(message::kRowsEnded, viewer.handle, reason, viewer.lane);
  // If the link is full, the channel is closed. Otherwise, the viewer would wait for rows forever.
  // The viewer opens the channel again, and then gets the reason.
  if (sent == Status(Status::kQueueFull)) viewer.channel->Close();
}

}  // namespace tendon
