#include "tests/fuzz/session/serve.hpp"

#include "protocol/errors.hpp"
#include "protocol/wire/content/clean_text.hpp"
#include "tests/fuzz/session/script.hpp"
#include "tests/fuzz/support/target.hpp"

namespace adit::fuzz {

bool serve(protocol::Participant& participant, const std::vector<wire::Frame>& requests) {
  protocol::Conversation conversation(participant);
  wire::Frame reply;
  for (const wire::Frame& request : requests) {
    if (!is_small(request.setup().scene()) || conversation.finished()) return false;
    const auto refused = [](const std::exception& error) {
      require_one_line(error.what());
      return false;
    };
    try {
      conversation.answer(request, reply);
    } catch (const protocol::UserError& error) {
      return refused(error);
    } catch (const protocol::RequestError& error) {
      return refused(error);
    } catch (const protocol::Unstable& error) {
      return refused(error);
    }
    protocol::clean_text(reply);
    conversation.complete();
  }
  return true;
}

}  // namespace adit::fuzz
