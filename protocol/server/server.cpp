#include "protocol/server/server.hpp"

#include <spdlog/spdlog.h>

#include <iostream>
#include <stop_token>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/server/listener.hpp"
#include "protocol/wire/error_frame.hpp"
#include "protocol/wire/greeting.hpp"

namespace adit::protocol {
namespace {

constexpr std::size_t kLongestRunId = 100;  // longest part of a client's text that logs and refusals repeat

// Answers one request. An error is an answer, too, also the error that the answer is too long to send.
void answer(Connection& connection, Listener& listener, Conversation& conversation,
            const wire::Frame& request, wire::Frame& reply) {
  try {
    conversation.answer(request, reply);
    if (conversation.finished()) listener.vacate();
    connection.send(reply);
  } catch (const PeerLost&) {
    throw;
  } catch (const std::exception& error) {
    fill_error(error, *reply.mutable_error());
    listener.vacate();
    connection.send(reply);
  }
}

void run(Connection& connection, Listener& listener, const std::string& program, Participant& participant) {
  handshake(connection, program);
  Conversation conversation(participant);
  std::string id = "(none)";
  wire::Frame request, reply;
  while (!conversation.finished() && !reply.has_error()) {
    connection.receive(request);
    if (request.has_setup()) {
      id = request.setup().run_id().substr(0, kLongestRunId);
      listener.occupy("run " + id);
      spdlog::info("run {} begins for {}", id, connection.peer());
    }
    answer(connection, listener, conversation, request, reply);
    conversation.complete();
  }
  if (reply.has_error()) {
    spdlog::error("run {} ended: {} {}", id, reply.error().path(), reply.error().message());
  } else {
    spdlog::info("run {} finished", id);
  }
}

}  // namespace

int serve(const ServerOptions& options, const ParticipantFactory& make_participant) {
  Listener listener(options.listen, options.insecure);
  // The line is flushed, because a coupler that starts the server waits for it to learn the port.
  std::cout << "listening on " << to_string(listener.address()) << std::endl;
  while (auto socket = listener.next_client()) {
    try {
      Connection connection(std::move(*socket), "client", options.patience);
      // A signal must also end a wait for this client.
      const std::stop_callback interrupt(listener.stopping(), [&] { connection.interrupt(); });
      // A new one for each run, so that nothing of a run can pass to the next.
      const auto participant = make_participant();
      run(connection, listener, options.program, *participant);
      connection.close();
    } catch (const std::exception& error) {
      if (!listener.stopping().stop_requested()) spdlog::warn("run dropped: {}", error.what());
    }
  }
  spdlog::info("stopped by a signal");
  return kSuccess;
}

}  // namespace adit::protocol
