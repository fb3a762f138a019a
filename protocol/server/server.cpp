#include "protocol/server/server.hpp"

#include <malloc.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <iostream>
#include <stop_token>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/log/log.hpp"
#include "protocol/server/begin_anew.hpp"
#include "protocol/server/listener.hpp"
#include "protocol/text.hpp"
#include "protocol/wire/content/clean_text.hpp"
#include "protocol/wire/content/error_frame.hpp"

namespace adit::protocol {
namespace {

// The longest wait for a request, or for the client to read an answer: it may wait for other participants.
std::chrono::milliseconds wait_in(const Conversation& conversation, const Connection& connection) {
  return conversation.builds() ? connection.patience().set_up : connection.patience().answer;
}

// Answers one request. An error is an answer, too, also the error that the answer is too long to send.
void answer(Connection& connection, Listener& listener, Conversation& conversation,
            const wire::Frame& request, wire::Frame& reply) {
  try {
    conversation.answer(request, reply);
    if (conversation.finished()) listener.vacate();
    clean_text(reply);
    connection.send(reply, wait_in(conversation, connection));
  } catch (const PeerLost&) {
    throw;
  } catch (const std::exception& error) {
    fill_error(error, *reply.mutable_error());
    listener.vacate();
    connection.send(reply);
  }
}

void receive(Connection& connection, const Conversation& conversation, wire::Frame& request) {
  connection.accept_up_to(conversation.longest_request());
  connection.receive(request, conversation.began() ? wait_in(conversation, connection)
                                                   : connection.patience().first_request);
}

constexpr std::chrono::seconds kProgressInterval{2};  // of the log

Progress reporter(Connection& connection) {
  return [&connection, last = std::chrono::steady_clock::now()](const std::string& how_far) mutable {
    connection.tell_progress(how_far);
    const auto now = std::chrono::steady_clock::now();
    if (now - last < kProgressInterval) return;
    last = now;
    spdlog::info("{}", how_far);
  };
}

void run(Connection& connection, Listener& listener, Participant& participant) {
  Conversation conversation(participant);
  participant.report_to(reporter(connection));
  std::string id = "(none)";
  wire::Frame request, reply;
  while (!conversation.finished() && !reply.has_error()) {
    receive(connection, conversation, request);
    if (request.has_setup()) {
      id = shorten(request.setup().run_id());
      listener.occupy("run " + id);
      log_run(id);
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
  Listener listener(options.listen, options.insecure || options.tls, options.stop_signals,
                    {options.program, options.secret, options.tls, options.patience, options.computes},
                    options.adopt);
  // The line is flushed, because a coupler that starts the server waits for it to learn the port.
  if (options.adopt < 0) std::cout << "listening on " << to_string(listener.address()) << std::endl;
  if (options.insecure && !options.tls)
    spdlog::warn("--insecure: nothing is encrypted. Anyone on the way can read and change what is sent{}",
                 options.secret.empty() ? ", and anyone who reaches this server can run models here" : "");
  while (const auto client = listener.next_client()) {
    try {
      if (options.begins_anew)
        client->when_gone([&, &connection = *client] {
          if (listener.stopping().stop_requested()) return;  // this end closed it
          spdlog::warn("{} has gone; its run is given up", connection.peer());
          begin_anew(options.command, listener.socket());
        });
      // A signal must also end a wait for this client.
      const std::stop_callback interrupt(listener.stopping(), [&] { client->interrupt(); });
      // A new one for each run, so that nothing of a run can pass to the next.
      const auto participant = make_participant();
      run(*client, listener, *participant);
      client->close();
    } catch (const std::exception& error) {
      if (!listener.stopping().stop_requested()) spdlog::warn("run dropped: {}", error.what());
    }
    log_run("");
    ::malloc_trim(0);  // the memory of a large model, which the next run may not need
  }
  spdlog::info("stopped by a signal");
  return kSuccess;
}

}  // namespace adit::protocol
