#include "coupler/recording/replay.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "coupler/check/text.hpp"
#include "coupler/recording/diff.hpp"
#include "coupler/recording/reader.hpp"
#include "coupler/recording/turns.hpp"
#include "protocol/errors.hpp"
#include "protocol/text.hpp"

namespace adit::coupler {
namespace {

Member member_of(const Speaker& speaker) {
  return {speaker.name, speaker.role, to_string(speaker.role)};
}

// A server that computes one model, and the bytes of its last answer, whose parts came one after another.
class Replayed {
 public:
  Replayed(const Member& member, const ServerChoice& choice)
      : joined_(join({member}, choice, {},
                     [this](const Member&, const wire::Hello&, protocol::Connection& connection) {
                       connection.overhear([this](protocol::Direction direction, auto frame) {
                         if (direction == protocol::Direction::kReceived)
                           heard_.append(reinterpret_cast<const char*>(frame.data()), frame.size());
                       });
                     })) {}

  // The server's answer, which may be an error. Throws protocol::PeerLost if it gives none.
  const wire::Frame& ask(const wire::Frame& request) {
    heard_.clear();
    try {
      connection().post(request);
      connection().collect(answer_);
    } catch (const std::exception&) {
      if (heard_.empty()) throw;
    }
    MessageReader().read(heard_, answer_);
    return answer_;
  }
  wire::Frame& answer() { return answer_; }

  std::string name() {
    return fmt::format("{} {} ({})", joined_.hellos.front().program(), joined_.hellos.front().release(),
                       connection().name());
  }

 private:
  Connection& connection() { return *joined_.participants.front().connection; }

  std::string heard_;
  JoinedServers joined_;
  wire::Frame answer_;
};

// How far a server answered as the recorded one.
struct Course {
  std::uint64_t equal = 0;  // answers
  std::string last;         // place of the last request
  std::optional<Difference> difference;
  std::string unanswered;  // what came of the last request, where the recording has no answer to it
};

std::string reaction_to(const wire::Frame& request, Replayed& server) {
  try {
    const wire::Frame& answer = server.ask(request);
    return answer.has_error() ? "error: " + protocol::one_line(answer.error().message()) : "answered";
  } catch (const protocol::PeerLost& error) {
    return error.what();
  }
}

Course follow(Turns& turns, Replayed& server) {
  Course course;
  // An error that the coupler sent ended the conversation.
  for (Turn turn; turns.next(turn) && !turn.request.has_error(); ++course.equal) {
    course.last = turn.place;
    if (!turn.answered) {
      course.unanswered = reaction_to(turn.request, server);
      return course;
    }
    server.ask(turn.request);
    course.difference = first_difference(turn.answer, server.answer());
    if (course.difference) return course;
  }
  return course;
}

bool replay_one(const std::filesystem::path& recording, std::uint16_t number, const Speaker& speaker,
                const ServerChoice& choice) {
  Turns turns(recording, number);
  Replayed server(member_of(speaker), choice);
  print_line(speaker.name, fmt::format("recorded of {} {}, replayed by {}", speaker.program, speaker.release,
                                       server.name()));
  const Course course = follow(turns, server);
  if (course.difference) {
    print_line("", fmt::format("first difference in the answer to {}: {} is {}, recorded {}", course.last,
                               course.difference->field, course.difference->b, course.difference->a));
    return false;
  }
  print_line("", fmt::format("equal: {} answers, up to {}", grouped(course.equal), course.last));
  if (!course.unanswered.empty())
    print_line("", fmt::format("the recording has no answer to {}; this server: {}", course.last,
                               course.unanswered));
  if (turns.cut()) print_line("", "the recording ends in the middle of an entry: its run was killed");
  return true;
}

}  // namespace

int replay(const std::filesystem::path& recording, const ServerChoice& choice, const std::string& only) {
  const std::vector<Speaker> speakers = RecordingReader(recording).speakers();
  std::vector<Member> members;
  for (const Speaker& speaker : speakers) members.push_back(member_of(speaker));
  const auto given = given_servers(choice, members);
  if (!only.empty() && std::none_of(speakers.begin(), speakers.end(),
                                    [&](const Speaker& speaker) { return speaker.name == only; }))
    throw protocol::UserError(
        "", fmt::format("--only names `{}`, which {} does not have", only, recording.string()));
  bool equal = true;
  for (std::size_t i = 0; i < speakers.size(); ++i) {
    const std::string& name = speakers[i].name;
    const auto address = given.find(name);
    if ((!only.empty() && name != only) || (!given.empty() && address == given.end())) continue;
    ServerChoice own = choice;
    own.fdm.clear();
    own.dem.clear();
    own.servers.clear();
    if (address != given.end()) own.servers = {name + "=" + address->second};
    equal = replay_one(recording, static_cast<std::uint16_t>(i), speakers[i], own) && equal;
  }
  print_line("not compared", kNotCompared);
  return equal ? 0 : kDifferent;
}

}  // namespace adit::coupler
