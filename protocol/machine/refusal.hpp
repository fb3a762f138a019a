// What the machine refuses to a program: memory, threads, open files, room on a disk, a file's permission.
#pragma once

#include <exception>
#include <optional>
#include <string>

#include "protocol/errors.hpp"

namespace adit::protocol {

struct Refusal {
  ExitCode code;        // kDiskFull or kUserError
  std::string message;  // what was refused, and what to do
};

// None where the error tells of something else.
std::optional<Refusal> refusal_of(const std::exception& error);

}  // namespace adit::protocol
