#include "coupler/checkpoint/state_file.hpp"

#include <algorithm>
#include <utility>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

std::filesystem::path path_of(const std::filesystem::path& folder, const std::string& name) {
  return folder / (name + ".state");
}

}  // namespace

StateWriter::StateWriter(const std::filesystem::path& folder, std::string name, std::string format)
    : file_(path_of(folder, name)), told_{std::move(name), std::move(format)} {}

void StateWriter::append(std::string_view part, std::uint32_t checksum) {
  file_.append(part);
  told_.bytes += part.size();
  told_.checksums.push_back(checksum);
}

StateFile StateWriter::close() {
  file_.flush();
  return std::move(told_);
}

StateReader::StateReader(const std::filesystem::path& folder, const StateFile& file)
    : path_(path_of(folder, file.name)), told_(file), left_(file.bytes) {
  if (!std::filesystem::is_regular_file(path_)) refuse("is not a file");
  stream_.open(path_, std::ios::binary);
  if (!stream_) refuse("cannot be opened");
}

bool StateReader::next(std::string& part) {
  if (parts_ == told_.checksums.size()) {
    if (left_ > 0) refuse("is longer than its checksums");
    return false;
  }
  part.resize(std::min<std::uint64_t>(left_, state::kPartBytes));
  if (!stream_.read(part.data(), static_cast<std::streamsize>(part.size()))) refuse("is too short");
  left_ -= part.size();
  ++parts_;
  return true;
}

void StateReader::require_right(const std::string& part) const {
  if (state::checksum(part) != checksum()) refuse("is damaged: its checksum is another one");
}

void StateReader::refuse(const char* why) const {
  throw protocol::UserError("", path_.string() + " " + why + "; take another checkpoint");
}

void require_whole(const std::filesystem::path& folder, const StateFile& file) {
  StateReader reader(folder, file);
  for (std::string part; reader.next(part);) reader.require_right(part);
}

state::Parts read_state(const std::filesystem::path& folder, const StateFile& file) {
  StateReader reader(folder, file);
  state::Parts parts;
  for (std::string part; reader.next(part); parts.push_back(part)) reader.require_right(part);
  return parts;
}

}  // namespace adit::coupler
