#include "protocol/scene/command_line.hpp"

#include <google/protobuf/stubs/logging.h>

#include "protocol/errors.hpp"
#include "protocol/log/log.hpp"
#include "protocol/log/option.hpp"
#include "protocol/release.hpp"

namespace adit::protocol {
// Single quotes keep every character; a quote itself stands outside of them.
std::string quoted_for_shell(const std::string& word) {
  constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

SceneCommandLine::SceneCommandLine(const std::string& program, const std::string& description)
    : app(description), program(program) {
  google::protobuf::SetLogHandler(nullptr);  // what it meets is told by this program, once and in its form
  app.set_version_flag("--version", program + " " + std::string(release()));
  app.require_subcommand(1);
  run = app.add_subcommand("run", "computes a scene");
  run->add_option("--out", out, "folder of the results [default: runs/<case>/<scene name>]");
  check = app.add_subcommand("check", "sets a scene up without computing it");
  for (CLI::App* command : {run, check}) {
    command->add_option("scene", scene, "scene file (YAML)")->required();
    command->add_option("--set", sets, "path=value: replaces a value of the scene; may be repeated")
        ->take_all()
        ->expected(1);
  }
}

std::optional<int> SceneCommandLine::parse(int argc, const char* const* argv) {
  for (int i = 0; i < argc; ++i) command += (i > 0 ? " " : "") + quoted_for_shell(argv[i]);
  for (CLI::App* each : app.get_subcommands({})) add_log_format(*each, log_format);
  try {
    app.parse(argc, argv);
    if (log_format == "json") log_as_json(program);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kSuccess : kUserError;
  }
}

}  // namespace adit::protocol
