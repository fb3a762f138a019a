#include "protocol/scene/hash.hpp"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>

#include <cstdint>
#include <cstdio>

#include "protocol/scene/attached_files.hpp"

namespace adit::protocol {
namespace {

std::string serialize(const scene::Scene& scene) {
  std::string bytes;
  google::protobuf::io::StringOutputStream stream(&bytes);
  google::protobuf::io::CodedOutputStream coded(&stream);
  coded.SetSerializationDeterministic(true);
  scene.SerializeToCodedStream(&coded);
  // The stream reserves memory in `bytes` ahead of what is written; the rest must not enter the hash.
  coded.Trim();
  return bytes;
}

}  // namespace

// Fowler, Noll and Vo, http://www.isthe.com/chongo/tech/comp/fnv
std::string hash_of_bytes(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001b3;
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

std::string scene_hash(const scene::Scene& scene) {
  scene::Scene computed = scene;
  computed.clear_name();
  computed.clear_extends();
  computed.clear_description();
  computed.clear_questions();
  computed.clear_accuracy();
  forget_file_names(computed);
  return hash_of_bytes(serialize(computed));
}

}  // namespace adit::protocol
