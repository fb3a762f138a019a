#include "protocol/log/log.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <mutex>

#include "protocol/standard_streams.hpp"
#include "protocol/text.hpp"

namespace adit::protocol {
namespace {

// Set before threads begin, but for the run.
struct {
  bool json = false;
  std::string program;
  std::mutex changing_run;
  std::string run;
} log;

std::string current_run() {
  const std::lock_guard lock(log.changing_run);
  return log.run;
}

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::kWarning:
      return "warning";
    case Severity::kError:
      return "error";
    default:
      return "info";
  }
}

}  // namespace

void log_as_json(std::string_view program) {
  log.json = true;
  log.program = program;
}

bool logs_json() {
  return log.json;
}

void log_run(std::string_view id) {
  const std::lock_guard lock(log.changing_run);
  log.run = id;
}

std::string json_line(std::chrono::system_clock::time_point time, std::string_view level,
                      std::string_view message) {
  using std::chrono::milliseconds;
  const auto since = std::chrono::duration_cast<milliseconds>(time.time_since_epoch());
  nlohmann::ordered_json line;
  line["time"] = fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z",
                             fmt::gmtime(std::chrono::system_clock::to_time_t(time)), since.count() % 1000);
  line["level"] = level;
  line["program"] = log.program;
  line["run"] = current_run();
  line["message"] = message;
  return line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void tell(Severity severity, std::string_view before, std::string_view message) {
  if (log.json)
    print_error(json_line(std::chrono::system_clock::now(), name_of(severity), message));
  else
    print_error(fmt::format("{}{}\n", before, one_line(message)));
}

}  // namespace adit::protocol
