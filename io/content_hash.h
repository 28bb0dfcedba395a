// The SHA-256 of some bytes: which data a result was made from.
//
// Source   [FIPS180] NIST FIPS 180-4, Secure Hash Standard, 2015; computed by libcrypto.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace plumb {

/// 64 lower-case hexadecimal digits, as `sha256sum` prints them.
std::string Sha256Hex(std::string_view bytes);

/// Of a file's bytes. Throws Error naming the file if it cannot be read.
std::string Sha256HexOfFile(const std::filesystem::path& path);

}  // namespace plumb
