#include "coupler/checkpoint/same_statics.hpp"

#include <google/protobuf/util/message_differencer.h>

#include <string>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/scene/attached_files.hpp"
#include "protocol/scene/fields/path.hpp"
#include "protocol/scene/hash.hpp"

namespace adit::coupler {
namespace {

using google::protobuf::Message;
using google::protobuf::util::MessageDifferencer;
using Fields = std::vector<MessageDifferencer::SpecificField>;

// Paths of what is another in two scenes.
class Differences : public MessageDifferencer::Reporter {
 public:
  std::vector<std::string> paths;

  void ReportAdded(const Message&, const Message&, const Fields& fields) override { add(fields); }
  void ReportDeleted(const Message&, const Message&, const Fields& fields) override { add(fields); }
  // A message is reported after what is another in it.
  void ReportModified(const Message&, const Message&, const Fields& fields) override {
    if (fields.back().field->cpp_type() != google::protobuf::FieldDescriptor::CPPTYPE_MESSAGE) add(fields);
  }

 private:
  void add(const Fields& fields) {
    std::string path;
    for (const auto& one : fields) {
      path = protocol::member_path(path, one.field->name());
      if (one.field->is_repeated()) path = protocol::element_path(path, static_cast<std::size_t>(one.index));
    }
    paths.push_back(path);
  }
};

// Leaves only what the state at rest depends on.
void reduce(scene::Scene& scene) {
  protocol::forget_file_names(scene);
  scene.clear_name();
  scene.clear_extends();
  scene.clear_description();
  scene.clear_questions();
  scene.clear_accuracy();
  scene.clear_output();
  scene::Time time;
  if (scene.time().has_substeps()) time.set_substeps(scene.time().substeps());
  *scene.mutable_time() = time;
  const auto reduce_base = [](scene::Continuum& continuum) {
    if (!continuum.has_base()) return;
    continuum.mutable_base()->clear_acceleration();
    continuum.mutable_base()->clear_across();
  };
  if (scene.has_continuum()) reduce_base(*scene.mutable_continuum());
  for (scene::Region& region : *scene.mutable_regions())
    if (region.has_continuum()) reduce_base(*region.mutable_continuum());
}

}  // namespace

void require_same_statics(scene::Scene before, scene::Scene now) {
  for (scene::Scene* scene : {&before, &now}) reduce(*scene);
  Differences differences;
  MessageDifferencer differencer;
  differencer.ReportDifferencesTo(&differences);
  differencer.Compare(before, now);
  if (differences.paths.empty()) return;
  throw protocol::UserError(
      differences.paths.front(),
      "is another than in the run whose state at rest is taken, or would be; only `time` without `substeps`, "
      "`output` and accelerations of a base may differ; leave out --from to compute statics anew");
}

std::string statics_hash(scene::Scene scene) {
  reduce(scene);
  return protocol::scene_hash(scene);
}

}  // namespace adit::coupler
