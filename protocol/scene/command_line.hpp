// The command line of a program that computes scenes: `PROGRAM run SCENE` and `PROGRAM check SCENE`.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace adit::protocol {

struct SceneCommandLine {
  SceneCommandLine(const std::string& program, const std::string& description);
  // The exit code where the program ends here: after --help and --version, or for what cannot be read.
  std::optional<int> parse(int argc, const char* const* argv);

  CLI::App app;
  CLI::App* run;    // parsed() where this is wanted; options of its own may be added
  CLI::App* check;  // likewise

  std::string scene;
  std::vector<std::string> sets;  // path=value
  std::string out;                // directory of the results; empty: the usual place
};

}  // namespace adit::protocol
