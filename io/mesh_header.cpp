#include "io/mesh_header.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

#include "core/error.h"
#include "io/regular_file.h"

namespace plumb {
namespace {

// Where the line "end_header" begins; npos if there is none.
std::size_t EndOfPlyHeader(const std::string& head) {
    const std::string word = "end_header";
    const auto is_space = [&](std::size_t at) {
        return at < head.size() && std::isspace(static_cast<unsigned char>(head[at])) != 0;
    };
    for (std::size_t at = head.find(word); at != std::string::npos;
         at = head.find(word, at + 1)) {
        if (at > 0 && (head[at - 1] == '\n' || head[at - 1] == '\r') &&
            is_space(at + word.size())) {
            return at;
        }
    }
    return std::string::npos;
}

void CheckPly(const std::filesystem::path& path, std::uintmax_t size) {
    constexpr std::size_t kLongestHeader = 1 << 16;
    std::string head(kLongestHeader, '\0');
    std::ifstream in(path, std::ios::binary);
    in.read(head.data(), std::streamsize(head.size()));
    head.resize(std::size_t(in.gcount()));
    const std::size_t end = EndOfPlyHeader(head);
    if (end == std::string::npos) throw Error(path.string() + ": PLY header has no end");
    // Each element takes a byte at least.
    std::istringstream words(head.substr(0, end));
    for (std::string word, name; words >> word;) {
        double count = 0;
        if (word != "element" || !(words >> name >> count)) {
            words.clear();
            continue;
        }
        if (count > double(size)) {
            throw Error(MustBe(path.string() + ": element " + name, count,
                               "at most the bytes of the file"));
        }
    }
}

std::uint32_t LittleEndian(std::ifstream& in) {
    unsigned char bytes[4] = {};
    in.read(reinterpret_cast<char*>(bytes), 4);
    return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | std::uint32_t(bytes[3]) << 24;
}

void CheckGlb(const std::filesystem::path& path, std::uintmax_t size) {
    std::ifstream in(path, std::ios::binary);
    in.seekg(12);
    std::uintmax_t at = 12;
    while (at + 8 <= size) {
        const std::uint32_t length = LittleEndian(in);
        at += 8 + std::uintmax_t(length);
        if (at > size) {
            throw Error(path.string() + ": is cut off or damaged: a chunk of " +
                        std::to_string(length) + " bytes ends beyond the file");
        }
        in.seekg(std::streamoff(at));
    }
}

}  // namespace

void CheckMeshHeader(const std::filesystem::path& path) {
    const std::uintmax_t size = RegularFileSize(path);
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    if (ending == ".ply") CheckPly(path, size);
    if (ending == ".glb") CheckGlb(path, size);
}

}  // namespace plumb
