// For any text, however wrong, the reader either succeeds or throws UserError.
#include <gtest/gtest.h>

#include <ctime>
#include <random>
#include <string_view>

#include "protocol/errors.hpp"
#include "protocol/messages/scene.pb.h"
#include "protocol/scene/fields/check_rules.hpp"
#include "protocol/scene/yaml/message_reader.hpp"

namespace adit::protocol::reader_garbage_test {
namespace {

// What the reader says of the text; empty where it accepts it. Anything but UserError ends the test.
std::string complaint(const std::string& text) {
  try {
    scene::Scene scene;
    read_message(parse_yaml(text, "x.yaml"), "", scene);
    check_rules(scene);
    return {};
  } catch (const UserError& error) {
    return error.what();
  }
}

constexpr std::string_view kScene = R"(name: beam
material: {young_modulus: 25 GPa, poisson_ratio: 0.2, density: 2.5 t/m^3}
time: {duration: 50 ms, dt_factor: 0.35}  # half
particles:
  packing: {x_min: 0, x_max: 10 m, y_min: 0, y_max: 1 m, radius: 6 cm}
  loads:
    - where: {x_max: 0.065 m}
      force: {y: 5 MN}
      time: {table: {time: [0, 10 ms, 0.5], value: [0, 1, 1]}}
  histories:
    - {name: "tip", quantity: displacement_y, at: {x: 0 m, y: 0.5 m}}
)";

constexpr std::string_view kPieces[] = {"{",    "}",     "[",     "]",           ": ",   "- ",  "? ", "\n",
                                        "\n  ", ",",     "&a ",   "*a",          "!!x ", "\"",  "'",  "|\n",
                                        ">\n",  "---\n", "...\n", "%YAML 1.2\n", "#",    "~",   "\t", "\xff",
                                        "\\u",  "1e9",   "inf",   "µ",           "@",    "time"};

// Deletes, copies or inserts a few pieces of the text.
std::string mutate(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  for (std::size_t n = 1 + below(4); n > 0; --n) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = below(12);
    switch (below(4)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, text.substr(below(text.size() + 1), length));
        break;
      case 2:
        text.insert(at, kPieces[below(std::size(kPieces))]);
        break;
      default:
        if (at < text.size()) text[at] = static_cast<char>(random());
    }
  }
  return text;
}

TEST(SceneGarbage, MutatedScenesAreReadOrRefusedInOneLine) {
  std::mt19937 random(1);
  int accepted = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::string text = mutate(std::string(kScene), random);
    const std::string answer = complaint(text);
    accepted += answer.empty() ? 1 : 0;
    EXPECT_EQ(answer.find('\n'), std::string::npos) << text;
  }
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, 4000);
}

TEST(SceneGarbage, RandomPiecesAreRefused) {
  std::mt19937 random(2);
  for (int i = 0; i < 4000; ++i) {
    std::string text;
    for (std::size_t n = random() % 40; n > 0; --n) text += kPieces[random() % std::size(kPieces)];
    EXPECT_NE(complaint(text), "") << text;
  }
}

// A MiB of the nastiest shapes ends within seconds of processor time and without exhausting the stack; a
// reader whose time grew with the square of the length would need hours.
TEST(SceneGarbage, LargeAndDeepFilesEndSoon) {
  constexpr std::size_t kBytes = 1 << 20;
  const auto repeat = [](std::string_view piece) {
    std::string text;
    while (text.size() + piece.size() <= kBytes) text += piece;
    return text;
  };
  for (const std::string_view piece :
       {"[", "{",  "- ",  "? ",   "a: ",   "[a, ", "{a: ", "\"", "'", "&a ", "!a ",   "#\n", "\n",
        " ", "\t", "|\n", "--- ", "---\n", "%A\n", ", ",   "]",  "}", "a",   "- a\n", "x\n"}) {
    const std::clock_t start = std::clock();
    EXPECT_NE(complaint(repeat(piece)), "") << piece;
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_LT(seconds, 30) << piece;
  }
}

}  // namespace
}  // namespace adit::protocol::reader_garbage_test
