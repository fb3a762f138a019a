#include "protocol/trust/tls.hpp"

#include <fmt/format.h>
#include <openssl/err.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>
#include <sys/socket.h>

#include <array>
#include <boost/asio/error.hpp>
#include <cerrno>
#include <ctime>
#include <string_view>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/text.hpp"
#include "protocol/trust/private_file.hpp"

namespace adit::protocol {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

// The first is the fastest for short frames, where processors have instructions for it.
constexpr const char* kCiphers = "TLS_AES_128_GCM_SHA256:TLS_AES_256_GCM_SHA384:TLS_CHACHA20_POLY1305_SHA256";

// The last error of OpenSSL in this thread; forgets all.
std::string openssl_error() {
  const char* reason = ERR_reason_error_string(ERR_peek_last_error());
  ERR_clear_error();
  return reason ? reason : "no reason given";
}

void require(int done, const std::filesystem::path& file, std::string_view what) {
  if (done != 1)
    throw UserError("", fmt::format("{} is no {} that can be used ({}): make it by adit certificates",
                                    file.string(), what, openssl_error()));
}

// A pipe in its place would be waited for.
void require_file(const std::filesystem::path& file, std::string_view what) {
  if (std::filesystem::exists(file) && !std::filesystem::is_regular_file(file))
    throw UserError(
        "", fmt::format("{}, for the {}, is not a file: make it by adit certificates", file.string(), what));
}

// OpenSSL would ask for a pass phrase at the terminal.
int no_pass_phrase(char*, int, int, void*) {
  return -1;
}

std::string common_name(const X509_NAME* name) {
  std::array<char, 256> text{};
  X509_NAME_get_text_by_NID(name, NID_commonName, text.data(), text.size());
  return one_line(text.data());
}

// What the peer says of the certificate of this end, by the alerts of RFC 8446, 6.2.
const char* refusal_of(int reason) {
  switch (reason) {
    case SSL_R_TLSV1_ALERT_UNKNOWN_CA:
    case SSL_R_TLSV1_ALERT_DECRYPT_ERROR:
      return "another authority has signed it; use folders that one call of adit certificates made";
    case SSL_R_SSLV3_ALERT_BAD_CERTIFICATE:  // what OpenSSL answers to one that begins later
      return "it is not valid yet, or is for another machine; compare the clocks of both machines and the "
             "names";
    case SSL_R_SSLV3_ALERT_CERTIFICATE_EXPIRED:
      return "it has expired, or begins later; make a new one by adit certificates";
    case SSL_R_TLSV13_ALERT_CERTIFICATE_REQUIRED:
      return "there is none; give the folder that adit certificates made for it by --tls";
    default:
      return nullptr;
  }
}

// Why this end does not accept the certificate of the peer.
std::string fault_of(long result, const std::string& name) {
  switch (result) {
    case X509_V_ERR_CERT_HAS_EXPIRED:
      return "has expired; make a new one by adit certificates";
    case X509_V_ERR_CERT_NOT_YET_VALID:
      return "is not valid yet; compare the clocks of both machines";
    case X509_V_ERR_HOSTNAME_MISMATCH:
    case X509_V_ERR_IP_ADDRESS_MISMATCH:
      return fmt::format("is not for {}; make one that names it by adit certificates", name);
    case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT_LOCALLY:
    case X509_V_ERR_SELF_SIGNED_CERT_IN_CHAIN:
    case X509_V_ERR_DEPTH_ZERO_SELF_SIGNED_CERT:
    case X509_V_ERR_CERT_SIGNATURE_FAILURE:
      return "was signed by another authority; use folders that one call of adit certificates made";
    default:
      return fmt::format("is not accepted ({})", X509_verify_cert_error_string(result));
  }
}

}  // namespace

Tls::Tls(const std::filesystem::path& folder, End end, bool accepts_uncertified)
    : context_(SSL_CTX_new(TLS_method()), SSL_CTX_free) {
  SSL_CTX* context = context_.get();
  if (!context) throw std::runtime_error("OpenSSL makes no context: " + openssl_error());
  const auto authority = folder / "authority.pem", certificate = folder / "certificate.pem";
  const auto key = folder / "key.pem";
  SSL_CTX_set_default_passwd_cb(context, no_pass_phrase);
  require_file(authority, "authority");
  require_file(certificate, "certificate");
  require(SSL_CTX_load_verify_locations(context, authority.c_str(), nullptr), authority, "authority");
  if (end == End::kServer || std::filesystem::exists(certificate) || std::filesystem::exists(key)) {
    require(SSL_CTX_use_certificate_chain_file(context, certificate.c_str()), certificate, "certificate");
    require_private(key, "the key");
    require(SSL_CTX_use_PrivateKey_file(context, key.c_str(), SSL_FILETYPE_PEM), key,
            "key of certificate.pem without a pass phrase");
  }
  SSL_CTX_set_min_proto_version(context, TLS1_3_VERSION);
  SSL_CTX_set_ciphersuites(context, kCiphers);
  SSL_CTX_set_verify(context, SSL_VERIFY_PEER | (accepts_uncertified ? 0 : SSL_VERIFY_FAIL_IF_NO_PEER_CERT),
                     nullptr);
  SSL_CTX_set_mode(context, SSL_MODE_ENABLE_PARTIAL_WRITE | SSL_MODE_ACCEPT_MOVING_WRITE_BUFFER);
  SSL_CTX_set_options(context, SSL_OP_IGNORE_UNEXPECTED_EOF);  // a peer that was killed has closed, too
  SSL_CTX_set_read_ahead(context, 1);                          // all that has arrived at once
  SSL_CTX_set_num_tickets(context, 0);                         // no session is resumed
}

TlsStream::TlsStream(const Tls& tls, End end, int socket, const std::string& name, std::string peer)
    : socket_(socket), ssl_(SSL_new(tls.context()), SSL_free), name_(name), peer_(std::move(peer)) {
  BIO* reads = BIO_new(BIO_s_mem());
  BIO* writes = BIO_new_socket(socket, BIO_NOCLOSE);
  if (!ssl_ || reads == nullptr || writes == nullptr)
    throw std::runtime_error("OpenSSL makes no connection: " + openssl_error());
  BIO_set_mem_eof_return(reads, -1);  // empty is not the end
  SSL_set_bio(ssl_.get(), reads, writes);
  if (end == End::kServer) {
    SSL_set_accept_state(ssl_.get());
    return;
  }
  SSL_set_connect_state(ssl_.get());
  X509_VERIFY_PARAM* verify = SSL_get0_param(ssl_.get());
  if (X509_VERIFY_PARAM_set1_ip_asc(verify, name.c_str()) != 1)
    X509_VERIFY_PARAM_set1_host(verify, name.c_str(), name.size());
}

TlsStream::Next TlsStream::handshake() {
  while (true) {
    const int code = SSL_do_handshake(ssl_.get());
    if (code == 1) return Next::kNothing;
    switch (SSL_get_error(ssl_.get(), code)) {
      case SSL_ERROR_WANT_WRITE:
        return Next::kWrite;
      case SSL_ERROR_WANT_READ: {
        error_code error;
        if (fetch(error)) continue;
        if (error == asio::error::would_block) return Next::kRead;
        [[fallthrough]];
      }
      case SSL_ERROR_ZERO_RETURN:
      case SSL_ERROR_SYSCALL:
        throw PeerLost(peer_, "closed the connection before TLS was agreed on");
      default:
        fail();
    }
  }
}

std::string TlsStream::certificate() const {
  const std::unique_ptr<X509, decltype(&X509_free)> peer(SSL_get1_peer_certificate(ssl_.get()), &X509_free);
  std::tm until{};
  ASN1_TIME_to_tm(X509_get0_notAfter(peer.get()), &until);
  return fmt::format(
      "of {}, signed by {}, until {:04}-{:02}-{:02}", common_name(X509_get_subject_name(peer.get())),
      common_name(X509_get_issuer_name(peer.get())), 1900 + until.tm_year, 1 + until.tm_mon, until.tm_mday);
}

std::size_t TlsStream::read_some(std::span<std::byte> into, error_code& error) {
  const std::lock_guard lock(mutex_);
  for (bool more = holds_bytes(); more || fetch(error); more = false) {
    std::size_t count = 0;
    error = outcome(SSL_read_ex(ssl_.get(), into.data(), into.size(), &count));
    if (error != asio::error::would_block) return count;
  }
  return 0;
}

std::size_t TlsStream::write_some(std::span<const std::byte> bytes, error_code& error) {
  const std::lock_guard lock(mutex_);
  std::size_t count = 0;
  error = outcome(SSL_write_ex(ssl_.get(), bytes.data(), bytes.size(), &count));
  return count;
}

bool TlsStream::holds_bytes() const {
  return SSL_has_pending(ssl_.get()) != 0 || BIO_ctrl_pending(SSL_get_rbio(ssl_.get())) > 0;
}

// Hands what has arrived at the socket to OpenSSL; false, with the reason, where that is nothing. An end that
// spins looks many times for each frame, and OpenSSL's own look at a socket takes three times as long.
bool TlsStream::fetch(error_code& error) {
  const ssize_t count = ::recv(socket_, arrived_.data(), arrived_.size(), MSG_DONTWAIT);
  if (count > 0)
    return BIO_write(SSL_get_rbio(ssl_.get()), arrived_.data(), static_cast<int>(count)) == count;
  error = count == 0 ? error_code(asio::error::eof) : error_code(errno, boost::system::system_category());
  return false;
}

std::string TlsStream::channel() const {
  constexpr std::string_view kLabel = "EXPORTER-Channel-Binding";
  std::array<unsigned char, 32> bytes;
  if (SSL_export_keying_material(ssl_.get(), bytes.data(), bytes.size(), kLabel.data(), kLabel.size(),
                                 nullptr, 0, 0) != 1)
    throw std::runtime_error("OpenSSL exports no key: " + openssl_error());
  return {bytes.begin(), bytes.end()};
}

void TlsStream::shut_down() {
  const std::lock_guard lock(mutex_);
  SSL_shutdown(ssl_.get());
  ERR_clear_error();
}

// OpenSSL tells what became of a call by the errors that its thread has not forgotten. Who meets one
// therefore forgets it: forgetting before each call takes a tenth of the call.
error_code TlsStream::outcome(int code) {
  if (code == 1) return {};
  switch (SSL_get_error(ssl_.get(), code)) {
    case SSL_ERROR_WANT_READ:
    case SSL_ERROR_WANT_WRITE:
      return asio::error::would_block;
    case SSL_ERROR_ZERO_RETURN:
      return asio::error::eof;
    case SSL_ERROR_SYSCALL:
      return {errno != 0 ? errno : ECONNRESET, boost::system::system_category()};
    default:
      fail();
  }
}

void TlsStream::fail() {
  const long result = SSL_get_verify_result(ssl_.get());
  const int reason = ERR_GET_REASON(ERR_peek_last_error());
  const std::string text = openssl_error();
  if (reason == SSL_R_WRONG_VERSION_NUMBER) throw NoTls("speaks without TLS");
  if (reason == SSL_R_HTTP_REQUEST || reason == SSL_R_HTTPS_PROXY_REQUEST) throw NoTls("speaks HTTP");
  if (result != X509_V_OK) throw UserError("", "the certificate of " + peer_ + " " + fault_of(result, name_));
  if (reason == SSL_R_PEER_DID_NOT_RETURN_A_CERTIFICATE) throw UserError("", peer_ + " has no certificate");
  if (const char* refusal = refusal_of(reason))
    throw UserError("", peer_ + " does not accept the certificate of this machine: " + refusal);
  throw PeerLost(peer_, "broke off TLS (" + text + ")");
}

}  // namespace adit::protocol
