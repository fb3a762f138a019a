#include "protocol/motion/records/records.hpp"

#include <utility>

#include "protocol/motion/records/record_text.hpp"

namespace adit::motion {
namespace {

// Files that state step and unit themselves.
void require_no_keys(const RecordText& text, const RecordKeys& keys) {
  if (keys.time_step > 0 || !keys.unit.empty())
    text.refuse(0, "states step and unit of its values; leave out `time_step` and `unit`");
}

void require_one_component(const RecordText& text, const RecordKeys& keys) {
  require_no_keys(text, keys);
  if (!keys.column.empty()) text.refuse(0, "holds one component; leave out `column`");
}

Motion parse(const RecordText& text, const RecordKeys& keys) {
  if (is_cosmos(text)) {
    require_no_keys(text, keys);
    return parse_cosmos(text, keys.column);
  }
  for (const auto& [is, read] :
       {std::pair{&is_knet, &parse_knet}, {&is_esm, &parse_esm}, {&is_at2, &parse_at2}})
    if (is(text)) {
      require_one_component(text, keys);
      return read(text);
    }
  return parse_table(text, keys);
}

}  // namespace

Motion parse_motion(const std::string& file, const std::string& content, const RecordKeys& keys) {
  return parse(split_text(file, content), keys);
}

}  // namespace adit::motion
