// Input that must be refused: where the error points, and what it says.
#pragma once

#include <gmock/gmock.h>

#include <ostream>
#include <string>

#include "protocol/errors.hpp"

namespace adit::test {

// `attempt` must end in a UserError at `path` whose message holds `text`.
template <class Attempt>
void expect_refusal(Attempt&& attempt, const std::string& path, const std::string& text) {
  try {
    attempt();
    ADD_FAILURE() << "accepted where it should say at `" << path << "`: " << text;
  } catch (const protocol::UserError& error) {
    EXPECT_EQ(error.path(), path);
    EXPECT_THAT(error.what(), testing::HasSubstr(text));
  }
}

// Rows of a table of refused input, for value-parameterized tests.
template <class Input>
struct Refusal {
  std::string name, path, message;
  Input input;
};

struct RefusedText {
  std::string name, text, path, message;
};

template <class Input>
std::ostream& operator<<(std::ostream& out, const Refusal<Input>& refusal) {
  return out << refusal.name;
}

inline std::ostream& operator<<(std::ostream& out, const RefusedText& refusal) {
  return out << refusal.name;
}

// The name of a row in the name of its test.
inline constexpr auto kRefusalName = [](const auto& info) { return info.param.name; };

}  // namespace adit::test
