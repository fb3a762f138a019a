#include "protocol/trust/secret.hpp"

#include <gtest/gtest.h>

namespace adit::protocol::secret_test {
namespace {

// The proof is HMAC-SHA256; the reference is Python's hmac.digest(b"key of sixteen b", text, "sha256").
TEST(Secret, ProofIsTheHmacOfWhoProvesAndBothChallenges) {
  const Challenges challenges{"of client", "of server"};
  const auto hex = [](const std::string& bytes) {
    std::string text;
    for (const unsigned char byte : bytes) {
      text += "0123456789abcdef"[byte / 16];
      text += "0123456789abcdef"[byte % 16];
    }
    return text;
  };
  EXPECT_EQ(hex(prove("key of sixteen b", End::kClient, challenges)),
            "55cf3a47dd4417cf2a8fbffaba5aa52b56ab74d5fc8da845d1e37da25cb0157b");
  EXPECT_EQ(hex(prove("key of sixteen b", End::kServer, challenges)),
            "28bf07d6d1bf7a308074ec0adaeb008e3e61fcb91e735de0279eea61431983ba");
  EXPECT_EQ(hex(prove("key of sixteen b", End::kClient, {"of client", "of server", "of channel"})),
            "54c2da640d2bb82e27ab16226496c37226a0e179b5b82941e8a05c8019d44b12");
}

// A proof that one end has heard is worth nothing to it: not in the other role, nor for another challenge,
// nor on another connection.
TEST(Secret, ProofsCannotBeUsedAgain) {
  const std::string secret = random_secret();
  const Challenges challenges{random_challenge(), random_challenge()};
  const std::string proof = prove(secret, End::kClient, challenges);
  EXPECT_TRUE(same_proof(proof, prove(secret, End::kClient, challenges)));
  EXPECT_FALSE(same_proof(proof, prove(secret, End::kServer, challenges)));
  EXPECT_FALSE(same_proof(proof, prove(secret, End::kClient, {challenges.of_client, random_challenge()})));
  EXPECT_FALSE(same_proof(proof, prove(secret, End::kClient, {random_challenge(), challenges.of_server})));
  EXPECT_FALSE(same_proof(proof, prove(random_secret(), End::kClient, challenges)));
  EXPECT_FALSE(same_proof(
      proof, prove(secret, End::kClient, {challenges.of_client, challenges.of_server, random_challenge()})));
  EXPECT_FALSE(same_proof(proof, ""));
  EXPECT_FALSE(same_proof(proof, proof.substr(1)));
}

TEST(Secret, RandomSecretsAreLongAndDiffer) {
  EXPECT_EQ(random_secret().size(), 64u);
  EXPECT_NE(random_secret(), random_secret());
  EXPECT_EQ(random_challenge().size(), 32u);
}

}  // namespace
}  // namespace adit::protocol::secret_test
