#include "protocol/wire/resolve.hpp"

#include <boost/asio/error.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <cstring>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <utility>

namespace adit::protocol {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

// The same bytes as an endpoint of one protocol.
template <class Protocol>
typename Protocol::endpoint as(const Endpoint& endpoint) {
  typename Protocol::endpoint result;
  std::memcpy(result.data(), endpoint.data(), endpoint.size());
  result.resize(endpoint.size());
  return result;
}

}  // namespace

Endpoints look_up(const Address& address, error_code& error) {
  if (!address.path.empty()) return {asio::local::stream_protocol::endpoint(address.path)};
  asio::io_context io;
  Endpoints endpoints;
  for (const auto& found :
       asio::ip::tcp::resolver(io).resolve(address.host, std::to_string(address.port), error))
    endpoints.emplace_back(found.endpoint());
  return endpoints;
}

Endpoints resolve(const Address& address, std::chrono::milliseconds within, error_code& error,
                  const Lookup& lookup) {
  struct Found {
    Endpoints endpoints;
    error_code error;
  };
  std::promise<Found> promise;
  auto found = promise.get_future();
  std::thread([address, lookup, promise = std::move(promise)]() mutable {
    Found result;
    result.endpoints = lookup(address, result.error);
    promise.set_value(std::move(result));
  }).detach();
  if (found.wait_for(within) == std::future_status::timeout) {
    error = asio::error::timed_out;
    return {};
  }
  Found result = found.get();
  error = result.error;
  return std::move(result.endpoints);
}

Address address_of(const Endpoint& endpoint) {
  if (endpoint.protocol().family() == AF_UNIX)
    return {.host = "", .port = 0, .path = as<asio::local::stream_protocol>(endpoint).path()};
  const auto tcp = as<asio::ip::tcp>(endpoint);
  return {tcp.address().to_string(), tcp.port()};
}

}  // namespace adit::protocol
