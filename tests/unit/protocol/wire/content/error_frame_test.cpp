// Requirement: an error is thrown at the other end as what it was thrown as at the first.
#include "protocol/wire/content/error_frame.hpp"

#include <gmock/gmock.h>

#include <boost/system/system_error.hpp>
#include <cerrno>
#include <new>

namespace adit::protocol::error_frame_test {
namespace {

// The message that arrives as an exception of the same kind; empty for another kind.
template <class Cause>
std::string arrives(const Cause& cause) {
  wire::Error error;
  fill_error(cause, error);
  try {
    throw_error("fdm_server", error);
  } catch (const Cause& arrived) {
    return arrived.what();
  } catch (const std::exception&) {
    return "";
  }
}

TEST(ErrorFrame, KeepsItsKind) {
  EXPECT_EQ(arrives(UserError("material", "is missing")), "is missing");
  EXPECT_EQ(arrives(UserError("", "cannot start 9 threads")), "fdm_server: cannot start 9 threads");
  EXPECT_EQ(arrives(Unstable("step 3")), "fdm_server: step 3");
  EXPECT_EQ(arrives(RequestError("2 impulses came")), "fdm_server cannot answer: 2 impulses came");
}

// A proto3 string that is not UTF-8 could not be parsed at the other end.
TEST(ErrorFrame, IsUtf8WhateverTheMessageQuotes) {
  EXPECT_EQ(arrives(UserError("material", "M\xe4rz\nforged")), "M\xef\xbf\xbdrz forged");
}

// What the machine of the sender refuses, its user can mend.
TEST(ErrorFrame, TellsWhatAMachineRefuses) {
  wire::Error error;
  fill_error(std::bad_alloc(), error);
  EXPECT_EQ(error.kind(), wire::Error::SCENE);
  EXPECT_EQ(error.message(),
            "there is not enough memory; make the model smaller, or raise the limit (ulimit -v)");
  fill_error(boost::system::system_error(EMFILE, boost::system::system_category(), "epoll"), error);
  EXPECT_EQ(error.message(),
            "epoll: Too many open files; raise the limit of open files and connections (ulimit -n)");
}

// A bug of the sender ends the conversation, not the receiver's program with a bug of its own.
// A peer may send a megabyte.
TEST(ErrorFrame, IsAsLongAsAUserReads) {
  wire::Error error;
  error.set_kind(wire::Error::UNSTABLE);
  error.set_message(std::string(1 << 20, 'x'));
  try {
    throw_error("dem_server", error);
  } catch (const Unstable& told) {
    EXPECT_LT(std::string(told.what()).size(), 3000u);
    EXPECT_TRUE(std::string(told.what()).ends_with("xx ..."));
  }
}

TEST(ErrorFrame, ABugOfTheSenderLosesThePeer) {
  wire::Error error;
  fill_error(std::logic_error("no such zone"), error);
  EXPECT_EQ(error.kind(), wire::Error::INTERNAL);
  EXPECT_THROW(throw_error("fdm_server", error), PeerLost);
}

}  // namespace
}  // namespace adit::protocol::error_frame_test
