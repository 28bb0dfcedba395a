#include "io/short_name.h"

#include "io/content_hash.h"

namespace plumb {

std::string ShortName(const std::string& name, const std::string& of) {
    constexpr std::size_t kHashDigits = 12;
    if (name.size() <= kMostOfName) return name;
    return name.substr(0, kMostOfName - kHashDigits - 1) + "-" +
           Sha256Hex(of).substr(0, kHashDigits);
}

}  // namespace plumb
