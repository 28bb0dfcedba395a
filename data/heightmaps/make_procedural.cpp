// Writes one procedural surface at its defaults, 256 x 256 on 1 m by 1 m, 0.1 m high, as a
// 16-bit PGM to standard output: 0 is the lowest height, 65535 the highest.
//
//     make_procedural stone_wall > stone_wall.pgm
#include <cmath>
#include <cstdio>
#include <iostream>

#include "heightfield/procedural/catalogue.h"

int main(int argc, char** argv) {
    using namespace plumb;
    try {
        const ProceduralKind& kind = ProceduralKindNamed(argc == 2 ? argv[1] : "");
        const HeightField field = kind.make(/*seed=*/1, Tile{});
        const double range_m = field.HighestM() - field.LowestM();
        std::printf("P5\n%d %d\n65535\n", field.Width(), field.Height());
        for (const double z_m : field.HeightsM().Pixels()) {
            const int stored = int(std::lround(65535 * ((z_m - field.LowestM()) / range_m)));
            std::putchar(stored >> 8);
            std::putchar(stored & 255);
        }
    } catch (const Error& error) {
        std::cerr << "make_procedural: " << error.what() << "\n";
        return 2;
    }
}
