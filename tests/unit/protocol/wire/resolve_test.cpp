// Requirement: a name server that does not answer holds nobody up beyond the deadline.
#include "protocol/wire/resolve.hpp"

#include <gtest/gtest.h>

#include <boost/asio/error.hpp>
#include <chrono>
#include <future>

namespace adit::protocol::resolve_test {
namespace {

using namespace std::chrono_literals;

TEST(Resolve, FindsAnAddress) {
  boost::system::error_code error;
  const Endpoints endpoints = resolve({"127.0.0.1", 4711}, 5s, error);
  EXPECT_FALSE(error);
  ASSERT_EQ(endpoints.size(), 1U);
  EXPECT_EQ(to_string(address_of(endpoints.front())), "127.0.0.1:4711");
}

TEST(Resolve, EndsAtTheDeadline) {
  std::promise<void> answered, left;
  boost::system::error_code error;
  const auto start = std::chrono::steady_clock::now();
  resolve({"nowhere", 1}, 50ms, error, [&](const Address&, boost::system::error_code&) {
    answered.get_future().wait();
    left.set_value();
    return Endpoints();
  });
  EXPECT_LT(std::chrono::steady_clock::now() - start, 5s);
  EXPECT_EQ(error, boost::asio::error::timed_out);
  answered.set_value();
  left.get_future().wait();
}

}  // namespace
}  // namespace adit::protocol::resolve_test
