#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace tendon {

enum class LogLevel : std::int32_t { kDebug, kInfo, kWarning, kError };

/// One line for people, to stderr and to every sink. `source` is a component's or a part's name.
/// Any thread but a real-time one: it locks and allocates.
void Log(LogLevel level, std::string_view source, std::string_view message);

/// Records below `level` are dropped; kInfo at the start.
void SetLogLevel(LogLevel level);

using LogSink = std::function<void(LogLevel, std::string_view source, std::string_view message)>;

/// Hears every record that is not dropped, in the logging thread. Kept for the life of the process.
void AddLogSink(LogSink sink);

}  // namespace tendon
