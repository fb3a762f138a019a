// A secret that two ends of a connection share, and the proof that an end knows it.
//
// The secret itself never travels. Each end sends a challenge of random bytes and proves its knowledge by the
// HMAC-SHA256 (RFC 2104) of both challenges. Who listens to one conversation learns nothing for the next. By
// TLS the proof also holds a value that only the two ends of the connection know: nobody can stand between
// them and pass proofs on.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "protocol/trust/end.hpp"

namespace adit::protocol {

// The environment variable by which the coupler hands a secret to a server that it starts. Other users cannot
// read the environment of a process.
inline constexpr const char* kSecretVariable = "ADIT_SECRET";

struct Challenges {
  std::string of_client;
  std::string of_server;
  std::string channel = {};  // TlsStream::channel(); empty without TLS
};

std::string random_challenge();  // 32 bytes
std::string random_secret();     // 64 hexadecimal digits

// The first line of a file. Throws UserError if the file cannot be read, can be read by other users, or holds
// fewer than 16 characters.
std::string read_secret(const std::filesystem::path& file);

// 32 bytes, which differ for the two ends: of the word `client` or `server`, both challenges and the channel,
// one after another.
std::string prove(std::string_view secret, End prover, const Challenges& challenges);

// Takes the same time wherever the two differ.
bool same_proof(std::string_view a, std::string_view b);

}  // namespace adit::protocol
