#include "protocol/server/reception.hpp"

#include <spdlog/spdlog.h>

#include <exception>
#include <utility>

#include "protocol/wire/greeting.hpp"

namespace adit::protocol {
namespace {

constexpr std::size_t kMostGuests = 32;

}  // namespace

Reception::Reception(Greeting greeting, Busy busy, Admit admit)
    : greeting_(std::move(greeting)), busy_(std::move(busy)), admit_(std::move(admit)) {}

Reception::~Reception() {
  for (Guest& guest : guests_) dismiss(guest);
}

void Reception::receive(Socket socket) {
  for (auto guest = guests_.begin(); guest != guests_.end();) {
    const bool gone = guest->gone;
    if (gone) guest->thread.join();
    guest = gone ? guests_.erase(guest) : std::next(guest);
  }
  if (guests_.size() == kMostGuests) {
    dismiss(guests_.front());
    guests_.pop_front();
  }
  try {
    std::list<Guest> next(1);
    Guest& guest = next.front();
    guest.connection = std::make_shared<Connection>(std::move(socket), "client", greeting_.patience);
    guest.thread = std::thread([this, &guest] { greet(guest); });
    guests_.splice(guests_.end(), next);
  } catch (const std::exception& error) {  // no thread is to be had, or the client has gone
    spdlog::warn("cannot greet a client: {}", error.what());
  }
}

void Reception::greet(Guest& guest) {
  try {
    if (greeting_.tls) secure_client(*guest.connection, *greeting_.tls);
    if (const auto refusal = admit(guest)) refuse(*guest.connection, *refusal);
  } catch (const std::exception& error) {
    spdlog::warn("client turned away: {}", error.what());
  }
  if (!guest.admitted) guest.connection->close();
  const std::lock_guard lock(admitting_);
  guest.connection.reset();
  guest.gone = true;
}

std::optional<std::string> Reception::admit(Guest& guest) {
  if (const auto refusal = greeting_.secret.empty() ? busy_() : std::nullopt) {
    guest.connection->send_preamble();
    return refusal;
  }
  handshake(*guest.connection, greeting_.program, End::kServer, greeting_.secret, greeting_.computes);
  const std::lock_guard lock(admitting_);
  const auto refusal = admit_(guest.connection);
  guest.admitted = !refusal;
  return refusal;
}

void Reception::dismiss(Guest& guest) {
  {
    const std::lock_guard lock(admitting_);
    if (guest.connection && !guest.admitted) guest.connection->interrupt();
  }
  guest.thread.join();
}

}  // namespace adit::protocol
