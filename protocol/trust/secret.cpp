#include "protocol/trust/secret.hpp"

#include <fmt/format.h>
#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <openssl/rand.h>

#include <array>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "protocol/errors.hpp"
#include "protocol/trust/private_file.hpp"

namespace adit::protocol {
namespace {

constexpr std::size_t kRandomBytes = 32;
constexpr std::size_t kShortestSecret = 16;
constexpr std::size_t kLongestSecret = 1024;

}  // namespace

std::string random_challenge() {
  std::array<unsigned char, kRandomBytes> bytes;
  if (RAND_bytes(bytes.data(), bytes.size()) != 1) throw std::runtime_error("no random bytes are to be had");
  return {bytes.begin(), bytes.end()};
}

std::string random_secret() {
  std::string digits;
  for (const char byte : random_challenge())
    digits += fmt::format("{:02x}", static_cast<unsigned char>(byte));
  return digits;
}

std::string read_secret(const std::filesystem::path& file) {
  require_private(file, "the secret");
  std::string secret(kLongestSecret + 1, '\0');
  std::ifstream stream(file);
  stream.getline(secret.data(), static_cast<std::streamsize>(secret.size()));
  secret.resize(std::strlen(secret.c_str()));
  if (secret.size() < kShortestSecret || secret.size() >= kLongestSecret)
    throw UserError("", fmt::format("the first line of {} is no secret of {} to {} characters: make one by "
                                    "`openssl rand -hex 32 > {}`",
                                    file.string(), kShortestSecret, kLongestSecret - 1, file.string()));
  return secret;
}

std::string prove(std::string_view secret, End prover, const Challenges& challenges) {
  const std::string text = (prover == End::kClient ? "client" : "server") + challenges.of_client +
                           challenges.of_server + challenges.channel;
  std::array<unsigned char, EVP_MAX_MD_SIZE> proof;
  unsigned int length = 0;
  if (!HMAC(EVP_sha256(), secret.data(), static_cast<int>(secret.size()),
            reinterpret_cast<const unsigned char*>(text.data()), text.size(), proof.data(), &length))
    throw std::runtime_error("OpenSSL computes no HMAC-SHA256");
  return {proof.begin(), proof.begin() + length};
}

bool same_proof(std::string_view a, std::string_view b) {
  return a.size() == b.size() && CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace adit::protocol
