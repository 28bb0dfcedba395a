#include "io/content_hash.h"

#include "core/error.h"
#include "io/data_uri.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

// [FIPS180], the examples of SHA-256 that NIST publishes with it: "abc" and the empty message.
TEST(Sha256, PublishedExamples) {
    EXPECT_EQ(Sha256Hex("abc"),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(Sha256Hex(""),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

using HashOfFile = TempFolder;

TEST_F(HashOfFile, IsThatOfItsBytes) {
    EXPECT_EQ(Sha256HexOfFile(Put("a.bin", "abc")), Sha256Hex("abc"));
    EXPECT_THROW(Sha256HexOfFile(Path("none")), Error);
}

// RFC 4648, section 10: "foobar" and the paddings of "fo" and "foo".
TEST_F(HashOfFile, DataUriIsBase64) {
    EXPECT_EQ(PngDataUri(Put("a", "foobar")), "data:image/png;base64,Zm9vYmFy");
    EXPECT_EQ(PngDataUri(Put("b", "fo")), "data:image/png;base64,Zm8=");
    EXPECT_EQ(PngDataUri(Put("c", "foo")), "data:image/png;base64,Zm9v");
}

}  // namespace
}  // namespace plumb
