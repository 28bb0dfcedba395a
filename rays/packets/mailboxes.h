// Which triangles a ray, or a packet of rays, has been tested against already.
//
// A triangle stands in the lists of several leaves. A small table of (triangle, ray) says which
// were met before; its place in the table is the triangle's number modulo the size. Where two
// triangles fall on one place the later one stays: the other may be tested again, which changes
// no result.
//
// Source   [Wald01 section 2.3]. For packets an entry also says for which rays: a ray that joins
//          in a later leaf has yet to be tested.
// Beware   One table a thread. It forgets nothing by itself: Next() begins with the next ray.
#pragma once

#include <array>
#include <cstdint>

namespace plumb {

class Mailboxes {
  public:
    void Next() {
        if (++ray_ == 0) {  // After 2^32 rays old entries would look new.
            entries_ = {};
            ray_ = 1;
        }
    }

    /// Whether all `rays` were tested against `triangle` before; from now on they were.
    bool WereTested(std::uint32_t triangle, std::uint64_t rays = 1) {
        Entry& entry = entries_[triangle % kSize];
        const bool known = entry.triangle == triangle && entry.ray == ray_;
        const std::uint64_t before = known ? entry.rays : 0;
        entry = {triangle, ray_, before | rays};
        return (rays & ~before) == 0;
    }

  private:
    static constexpr std::uint32_t kSize = 64;
    struct Entry {
        std::uint32_t triangle = 0, ray = 0;
        std::uint64_t rays = 0;
    };

    std::array<Entry, kSize> entries_{};
    std::uint32_t ray_ = 0;
};

}  // namespace plumb
