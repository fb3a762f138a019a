// TLS 1.3: each end shows the certificate of its machine and accepts those that the same authority has
// signed. Where clients must prove that they know a secret, they need no certificate. adit certificates
// makes the folders.
#pragma once

#include <openssl/types.h>

#include <boost/system/error_code.hpp>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "protocol/trust/end.hpp"

namespace adit::protocol {

// The identity of one machine, and whom it trusts.
class Tls {
 public:
  // Reads authority.pem, certificate.pem and key.pem of a folder; a client may lack the last two. Throws
  // UserError if one is missing, cannot be read, or does not belong to the others, and if other users may
  // read the key. `accepts_uncertified`: clients without certificate.
  Tls(const std::filesystem::path& folder, End end, bool accepts_uncertified = false);

  SSL_CTX* context() const { return context_.get(); }

 private:
  std::shared_ptr<SSL_CTX> context_;
};

// The peer does not speak TLS; the message says what it speaks.
class NoTls : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// TLS on a connected, non-blocking socket, which it does not own. One thread may read while another writes.
class TlsStream {
 public:
  enum class Next { kNothing, kRead, kWrite };  // what the socket must be ready for

  // `name`: of the machine that a client wants to reach, which the server's certificate must hold; errors say
  // `peer`.
  TlsStream(const Tls& tls, End end, int socket, const std::string& name, std::string peer);

  // To be called until it returns kNothing. Throws NoTls, or UserError if one end does not accept the other.
  Next handshake();

  // Of the peer: whose it is, by which authority, until when; after the handshake.
  std::string certificate() const;

  // As those of a socket, with its error codes: would_block, eof. They throw UserError if the peer does not
  // accept the certificate of this end. What could not be written must be tried again before anything else.
  std::size_t read_some(std::span<std::byte> into, boost::system::error_code& error);
  std::size_t write_some(std::span<const std::byte> bytes, boost::system::error_code& error);

  // 32 bytes that only the two ends of this connection can compute: tls-exporter of RFC 9266. To be called
  // after the handshake.
  std::string channel() const;

  // Says that this end sends no more.
  void shut_down();

 private:
  bool holds_bytes() const;  // of what was fetched
  bool fetch(boost::system::error_code& error);
  boost::system::error_code outcome(int code);
  [[noreturn]] void fail();

  std::mutex mutex_;
  int socket_;
  std::shared_ptr<SSL> ssl_;
  std::vector<std::byte> arrived_ = std::vector<std::byte>(std::size_t{64} << 10);
  std::string name_, peer_;
};

}  // namespace adit::protocol
