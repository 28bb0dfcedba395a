// A grey PNG of few bits a pixel, byte by byte: the writers at hand make no fewer than 8.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace plumb {

/// The PNG checksum by its definition, bit by bit (ISO 3309).
inline std::uint32_t PngCrc(const std::string& bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (char byte : bytes) {
        crc ^= std::uint8_t(byte);
        for (int k = 0; k < 8; ++k) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return ~crc;
}

inline std::string BigEndian(std::uint32_t number) {
    std::string bytes;
    for (int k = 3; k >= 0; --k) bytes += char(number >> 8 * k);
    return bytes;
}

inline std::string PngChunk(const std::string& type, const std::string& data) {
    return BigEndian(std::uint32_t(data.size())) + type + data + BigEndian(PngCrc(type + data));
}

/// [PNG] ISO/IEC 15948: one row of numbers below 2^bits, 1, 2, 4 or 8 bits each, packed from
/// the high bits down; the deflate stream holds one stored block [RFC 1951 3.2.4].
inline std::string GreyPngRow(int bits, const std::vector<int>& numbers) {
    std::string row(1, '\0');  // No filter.
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const std::size_t at = k * std::size_t(bits) / 8;
        if (at + 1 >= row.size()) row += '\0';
        const int shift = 8 - bits - int(k * std::size_t(bits) % 8);
        row[at + 1] = char(row[at + 1] | numbers[k] << shift);
    }
    std::uint32_t a = 1, b = 0;  // Adler-32 [RFC 1950].
    for (char byte : row) {
        a = (a + std::uint8_t(byte)) % 65521;
        b = (b + a) % 65521;
    }
    const auto size = std::uint16_t(row.size());
    const std::string block{'\x78',          '\x01',      '\x01',          char(size),
                            char(size >> 8), char(~size), char(~size >> 8)};
    const std::string header = BigEndian(std::uint32_t(numbers.size())) + BigEndian(1) +
                               char(bits) + std::string(4, '\0');
    return "\x89PNG\r\n\x1a\n" + PngChunk("IHDR", header) +
           PngChunk("IDAT", block + row + BigEndian(b << 16 | a)) + PngChunk("IEND", "");
}

}  // namespace plumb
