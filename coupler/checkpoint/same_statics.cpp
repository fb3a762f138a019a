#include "coupler/checkpoint/same_statics.hpp"

#include <google/protobuf/util/message_differencer.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/scene/attached_files.hpp"
#include "protocol/scene/fields/path.hpp"

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

bool may_differ(std::string_view path) {
  constexpr std::array<std::string_view, 5> kFree{"name", "extends", "description", "time", "output"};
  const std::string_view first = path.substr(0, path.find('.'));
  if (path.starts_with("time.substeps")) return false;
  return std::ranges::find(kFree, first) != kFree.end() ||
         path.find("base.acceleration") != std::string_view::npos ||
         path.find("base.across") != std::string_view::npos;
}

}  // namespace

void require_same_statics(scene::Scene before, scene::Scene now) {
  for (scene::Scene* scene : {&before, &now}) protocol::forget_file_names(*scene);
  Differences differences;
  MessageDifferencer differencer;
  differencer.ReportDifferencesTo(&differences);
  differencer.Compare(before, now);
  for (const std::string& path : differences.paths)
    if (!may_differ(path))
      throw protocol::UserError(
          path,
          "is another than in the run whose state at rest is taken, or would be; only `time` without "
          "`substeps`, "
          "`output` and accelerations of a base may differ; leave out --from to compute statics anew");
}

}  // namespace adit::coupler
