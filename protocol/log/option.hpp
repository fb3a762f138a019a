// The option by which all programs choose how they log.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace adit::protocol {

// Puts `text` or `json` into `format`.
inline void add_log_format(CLI::App& command, std::string& format) {
  command.add_option("--log-format", format, "how standard error tells of the work: text, or JSON lines")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
}

}  // namespace adit::protocol
