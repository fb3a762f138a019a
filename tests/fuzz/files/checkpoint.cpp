// A checkpoint's folder: what stands before the line `---` is checkpoint.json, what follows the state `x`.
#include "coupler/checkpoint/checkpoints.hpp"
#include "protocol/state/archive.hpp"
#include "tests/fuzz/support/target.hpp"
#include "tests/support/scratch_folder.hpp"

namespace adit::fuzz {
namespace {

constexpr std::string_view kDivider = "\n---\n";
constexpr std::size_t kMemory = 2 * state::kPartBytes;  // a part of a state is read at once

const Target kCheckpoint(
    "checkpoint",
    [](std::string_view input) {
      static const test::ScratchFolder folder;
      const auto end = std::min(input.find(kDivider), input.size());
      folder.write("checkpoint.json", std::string(input.substr(0, end)));
      folder.write("x.state", std::string(input.substr(std::min(end + kDivider.size(), input.size()))));
      read_or_refuse([&] { coupler::read_checkpoint(folder.path()); });
    },
    kMemory);

}  // namespace
}  // namespace adit::fuzz
