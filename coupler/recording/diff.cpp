#include "coupler/recording/diff.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "coupler/check/text.hpp"
#include "coupler/recording/difference.hpp"
#include "coupler/recording/reader.hpp"
#include "coupler/recording/turns.hpp"

namespace adit::coupler {
namespace {

// A difference in the `turn`-th turn of a participant.
struct Finding {
  std::uint64_t turn;
  bool in_answer;
  std::string text;

  bool operator<(const Finding& other) const {
    return std::tie(turn, in_answer) < std::tie(other.turn, other.in_answer);
  }
};

struct Comparison {
  std::uint64_t turns = 0;  // that both have
  std::string last;         // place of the last of them
  std::vector<Finding> findings;
};

bool next(Turns& turns, Turn& turn) {
  while (turns.next(turn))
    if (!turn.request.has_save()) return true;
  return false;
}

std::string told(const std::string& place, const Difference& difference) {
  return fmt::format("{}: {} is {} in A, {} in B", place, difference.field, difference.a, difference.b);
}

// The first request and the first answer that differ; nothing is compared beyond different requests of
// another kind, because the turns no longer belong together.
Comparison compare(Turns& of_a, Turns& of_b) {
  Comparison comparison;
  bool asked = false, answered = false;
  for (Turn a, b; !(asked && answered); ++comparison.turns) {
    const bool in_a = next(of_a, a), in_b = next(of_b, b);
    if (!in_a && !in_b) return comparison;
    if (in_a != in_b) {
      comparison.findings.push_back({comparison.turns, false,
                                     fmt::format("{} has no more, {} goes on with {}", in_a ? "B" : "A",
                                                 in_a ? "A" : "B", in_a ? a.place : b.place)});
      return comparison;
    }
    comparison.last = a.place;
    const bool same_kind = a.request.content_case() == b.request.content_case();
    if (const auto found = first_difference(a.request, b.request); found && !asked) {
      comparison.findings.push_back({comparison.turns, false, told("request of " + a.place, *found)});
      asked = true;
    }
    if (!same_kind || (!a.answered && !b.answered)) return comparison;
    if (a.answered != b.answered) {
      comparison.findings.push_back(
          {comparison.turns, true,
           fmt::format("only {} has an answer to {}", a.answered ? "A" : "B", a.place)});
      return comparison;
    }
    if (answered) continue;
    if (const auto found = first_difference(a.answer, b.answer)) {
      comparison.findings.push_back({comparison.turns, true, told("answer to " + a.place, *found)});
      answered = true;
    }
  }
  return comparison;
}

std::optional<std::uint16_t> find(const std::vector<Speaker>& speakers, const std::string& name) {
  const auto found = std::find_if(speakers.begin(), speakers.end(),
                                  [&](const Speaker& speaker) { return speaker.name == name; });
  if (found == speakers.end()) return std::nullopt;
  return static_cast<std::uint16_t>(found - speakers.begin());
}

void print_programs(const char* label, const std::filesystem::path& path,
                    const std::vector<Speaker>& speakers) {
  std::vector<std::string> programs;
  programs.reserve(speakers.size());
  for (const Speaker& speaker : speakers)
    programs.push_back(fmt::format("{} by {} {}", speaker.name, speaker.program, speaker.release));
  print_line(label, fmt::format("{}: {}", path.string(), fmt::join(programs, ", ")));
}

}  // namespace

int diff(const std::filesystem::path& a, const std::filesystem::path& b) {
  const std::vector<Speaker> in_a = RecordingReader(a).speakers(), in_b = RecordingReader(b).speakers();
  print_programs("A", a, in_a);
  print_programs("B", b, in_b);
  std::vector<std::pair<Finding, std::string>> all;  // with the participant's name
  for (const Speaker& speaker : in_b)
    if (!find(in_a, speaker.name)) all.push_back({{0, false, "is in B only"}, speaker.name});
  for (const Speaker& speaker : in_a) {
    const auto other = find(in_b, speaker.name);
    if (!other) {
      all.push_back({{0, false, "is in A only"}, speaker.name});
      continue;
    }
    Turns of_a(a, *find(in_a, speaker.name)), of_b(b, *other);
    const Comparison comparison = compare(of_a, of_b);
    for (const Finding& finding : comparison.findings) all.emplace_back(finding, speaker.name);
    if (comparison.findings.empty())
      print_line(speaker.name, fmt::format("equal: {} requests and their answers, up to {}",
                                           grouped(comparison.turns), comparison.last));
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  for (const auto& [finding, name] : all) print_line(name, finding.text);
  print_line("not compared", kNotCompared);
  return all.empty() ? 0 : kDifferent;
}

}  // namespace adit::coupler
