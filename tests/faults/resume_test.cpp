// plumb truth, killed outright wherever it is, goes on to the bytes of a run that was not.
#include <gtest/gtest.h>

#include <csignal>

#include "tests/faults/program.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

class Resume : public TempFolder {};

TEST_F(Resume, GoesOnToTheSameBytesAfterKill9) {
    const std::string line =
        "truth cornell_box --width 48 --height 32 --bounces 2 --spp 4096 --quiet --out ";
    ASSERT_EQ(RunPlumb(Words(line + "whole"), {.folder = folder_}).status, 0);
    int killed = 0;
    for (const double cpu_s : {0.0, 0.05, 0.15, 0.3, 0.6}) {
        Program program(Words(line + "killed"), {.folder = folder_});
        if (!program.IsAtWork(cpu_s)) break;
        program.Send(SIGKILL);
        killed += program.Wait(60).status == 128 + SIGKILL;
    }
    EXPECT_GE(killed, 2);
    ASSERT_EQ(RunPlumb(Words(line + "killed"), {.folder = folder_}).status, 0);
    for (const char* name :
         {"truth.exr", "truth.html", "truth.json", "truth.csv", "truth.png"}) {
        const std::string folder = std::string("whole/") + name;
        EXPECT_NE(Get(folder), "") << name;
        EXPECT_EQ(Get(folder), Get(std::string("killed/") + name)) << name;
    }
}

}  // namespace
}  // namespace plumb
