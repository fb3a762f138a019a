// The models of a scene and what joins them, under their names.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

enum class Role { kContinuum, kParticles };
const char* to_string(Role role);  // "continuum", "particles": the scene's own names

// A model, computed by one participant.
struct Member {
  std::string name;  // "continuum", "particles", or that of a region
  Role role;
  std::string path;  // in the scene: "continuum", "regions[1].particles"
};
inline bool is_region(const Member& member) {
  return member.name != to_string(member.role);
}

// Two members, by their places in the list of members.
struct Join {
  std::size_t outer, inner;
  const scene::Interface* interface;
  std::string path;  // in the scene: "interface", "interfaces[0]"
};

// The models that the scene names: continuum first, then particles, then the regions in their order. Throws
// protocol::UserError for a scene without any, or with two of one name.
std::vector<Member> members(const scene::Scene& scene);

// The interfaces between them. Throws protocol::UserError for names that no model has, for a model that is
// joined to nothing, and for a pair that is joined twice.
std::vector<Join> joins(const scene::Scene& scene, const std::vector<Member>& members);

// What a participant gets: its own model under `continuum` or `particles`, and what concerns all; nothing of
// the other models, of the interfaces, of the results.
scene::Scene part_of(const scene::Scene& scene, const Member& member);

// The continuum of a member whose role it is.
const scene::Continuum& continuum_of(const scene::Scene& scene, const Member& member);

// The particles of a member whose role it is.
const scene::Particles& particles_of(const scene::Scene& scene, const Member& member);

// What the scene wants to know of a model, in the order of its answers.
const google::protobuf::RepeatedPtrField<scene::History>& histories_of(const scene::Scene& scene,
                                                                       const Member& member);

}  // namespace adit::coupler
