#include "io/content_hash.h"

#include <openssl/evp.h>

#include <array>

#include "core/error.h"
#include "io/whole_file.h"

namespace plumb {

std::string Sha256Hex(std::string_view bytes) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned size = 0;
    if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) !=
        1) {
        throw MachineError("libcrypto has no SHA-256");
    }
    std::string hex;
    for (unsigned i = 0; i < size; ++i) {
        hex += "0123456789abcdef"[digest[i] >> 4];
        hex += "0123456789abcdef"[digest[i] & 15];
    }
    return hex;
}

std::string Sha256HexOfFile(const std::filesystem::path& path) {
    return Sha256Hex(ReadWholeFile(path));
}

}  // namespace plumb
