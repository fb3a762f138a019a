// What a program tells of its work on standard error: as text for people, or as JSON lines for other
// programs.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace adit::protocol {

// Lines of JSON from now on, which name the program.
void log_as_json(std::string_view program);
bool logs_json();

// The run of which the lines to come tell; empty: none.
void log_run(std::string_view id);

// `{"time":"2026-11-23T04:31:07.123Z","level":"info","program":"coupler","run":"cantilever","message":"…"}`
// with the end of the line. Bytes that are not UTF-8 become U+FFFD.
std::string json_line(std::chrono::system_clock::time_point time, std::string_view level,
                      std::string_view message);

enum class Severity { kInfo, kWarning, kError };

// Writes one line at once. Text begins with `before`, for which JSON has the level.
void tell(Severity severity, std::string_view before, std::string_view message);

}  // namespace adit::protocol
