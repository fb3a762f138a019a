#include "protocol/scene/file_content.hpp"

#include <fstream>
#include <ios>
#include <iterator>

namespace adit::protocol {

std::optional<std::string> file_content(const std::filesystem::path& file) try {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
} catch (const std::ios_base::failure&) {
  return std::nullopt;
}

}  // namespace adit::protocol
