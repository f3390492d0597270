#pragma once

#include <tendon/payload/channel_value.h>

#include <QList>
#include <QMetaType>
#include <optional>

namespace tendon::gui {

/// How a number went, as a small curve beside it.
struct Trend {
  QList<double> parts;  ///< oldest first, from 0 to 1; not-a-number where there is no place for it
  bool is_stepped = false;  ///< each holds until the next one
};

/// Of the last values of a channel, nothing where a row had none.
[[nodiscard]] Trend TrendOf(const Schema& channel,
                            const QList<std::optional<ChannelValue>>& values);

}  // namespace tendon::gui

Q_DECLARE_METATYPE(tendon::gui::Trend)
