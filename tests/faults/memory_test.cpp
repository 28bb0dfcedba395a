// Too little memory: status 3 and a message, or it is enough. Never a crash.
#include <gmock/gmock.h>

#include <ostream>

#include "tests/faults/program.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

using testing::AnyOf;

constexpr const char* kHungry[] = {
    "simulate make:stone_wall:256 --slices 16",
    "fit make:bricks:128 make:cobbles:128 --slices 8 --no-studies --bootstrap 0 --starts 1",
    "truth atrium --width 480 --height 270 --spp 64",
    "truth wedge --facets --spp 16",
    "render atrium --technique gtao-xegtao --width 960 --height 540",
    "report wedge --width 480 --height 270 --spp 16 --rounds 1 --no-studies --technique "
    "gtao-paper",
    "bench raster atrium --rounds 5",
};

class Memory : public TempFolder, public testing::WithParamInterface<const char*> {};

#ifndef __SANITIZE_ADDRESS__
TEST_P(Memory, TooLittleIsStatus3) {
    for (const std::uint64_t mebibytes : {200, 260, 320, 400, 460, 520, 600, 700}) {
        const Ended ended =
            RunPlumb(Words(GetParam()), {.folder = folder_, .memory_bytes = mebibytes << 20});
        // 127: not even the program and its libraries fit.
        EXPECT_THAT(ended.status, AnyOf(0, 3, 127)) << mebibytes << " MiB: " << ended.errors;
        EXPECT_TRUE(ended.status == 0 || !ended.errors.empty()) << mebibytes << " MiB";
        EXPECT_THAT(PartsBelow(folder_), testing::IsEmpty());
    }
}

INSTANTIATE_TEST_SUITE_P(Every, Memory, testing::ValuesIn(kHungry));
#endif

}  // namespace
}  // namespace plumb
