// The command line of a program that computes scenes: `PROGRAM run SCENE` and `PROGRAM check SCENE`.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace adit::protocol {

// The word as a shell must read it.
std::string quoted_for_shell(const std::string& word);

struct SceneCommandLine {
  SceneCommandLine(const std::string& program, const std::string& description);
  // The exit code if the program ends here: after --help or --version, or because of a wrong command line.
  std::optional<int> parse(int argc, const char* const* argv);

  CLI::App app;
  CLI::App* run;    // run->parsed() tells whether it was asked for; programs may add options to it
  CLI::App* check;  // likewise

  std::string program;
  std::string log_format = "text";
  std::string command;  // all of it, quoted for a shell
  std::string scene;
  std::vector<std::string> sets;  // path=value
  std::string out;                // folder of the results; empty: runs/<case>/<scene name>
};

}  // namespace adit::protocol
