// The hash of input files: the examples of FIPS 180-4, and every length around the ends of a block.
#include "output/report/sha256.h"

#include "support/catch.h"

namespace exsect::sha256_test {
namespace {

TEST_CASE("the hash of known texts") {
  CHECK(cli::sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(cli::sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(cli::sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(cli::sha256(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("the hash of texts whose length is near a block's") {
  // The hash of all hashes of n zero bytes, n = 0 .. 260, one after the other, by Python's hashlib.
  std::string all;
  for (std::size_t n = 0; n <= 260; ++n) all += cli::sha256(std::string(n, '\0'));
  CHECK(cli::sha256(all) == "0734a545c881c217b7b024905d5f6a61ee7e2b4036df0689b710c490586cb5ec");
}

}  // namespace
}  // namespace exsect::sha256_test
