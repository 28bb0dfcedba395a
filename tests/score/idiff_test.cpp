// 50 pairs of pictures through idiff itself, where it is installed (Debian: openimageio-tools): mean,
// RMS, PSNR and maximum are those that --like idiff says, to the digits that it prints.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "core/random.h"
#include "io/image_io.h"
#include "jobs/score/like_tool.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

class Idiff : public TempFolder {
  protected:
    static bool IsInstalled() {
        return std::system("command -v idiff oiiotool >/dev/null 2>&1") == 0;
    }

    static std::string OutputOf(const std::string& command) {
        std::string output;
        FILE* pipe = popen((command + " 2>&1").c_str(), "r");
        std::array<char, 4096> buffer;
        while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr)
            output += buffer.data();
        pclose(pipe);
        return output;
    }

    /// A picture of its own for each seed: `base` at random, and off it by up to `spread`.
    void Write(const std::string& name, int channels, double scale, std::uint64_t seed,
               double spread, std::uint64_t noise_seed) {
        const int width = 5 + int(seed % 37), height = 3 + int(seed % 23);
        std::vector<NamedChannel> made;
        for (int c = 0; c < channels; ++c) {
            Image<float> image(width, height);
            for (std::size_t p = 0; p < image.Pixels().size(); ++p) {
                const double base = RandomUnit(seed, p, std::uint64_t(c), 0);
                const double off = RandomUnit(noise_seed, p, std::uint64_t(c), 1) - 0.5;
                image.Pixels()[p] =
                    float(scale * std::min(1.0, std::max(0.0, base + spread * off)));
            }
            const char* names[] = {"R", "G", "B", "A"};
            made.push_back({channels == 1 ? "Y" : names[c], std::move(image)});
        }
        WriteExr(Path(name), made);
    }

    void ExpectTheSame(const std::string& c, const std::string& t) {
        const std::string said = OutputOf("idiff " + Path(c).string() + " " + Path(t).string());
        const auto number = [&](const std::string& label) {
            const std::size_t at = said.find(label);
            if (at == std::string::npos) return std::nan("");
            return std::atof(said.c_str() + said.find('=', at) + 1);
        };
        const auto read = [&](const std::string& name) {
            return ReadPictureToScore({Path(name), ""});
        };
        const doc::Table table = LikeTable("idiff", {read(c)}, read(t));
        const char* labels[] = {"Mean error", "RMS error", "Peak SNR", "Max error"};
        for (std::size_t k = 0; k < 4; ++k) {
            const double ours = doc::NumberOf(table.At(k, "value")), theirs = number(labels[k]);
            // It prints six significant digits.
            EXPECT_NEAR(ours, theirs, 1e-5 * std::abs(theirs)) << labels[k] << ":\n" << said;
        }
    }
};

TEST_F(Idiff, SaysTheSameOf50Pairs) {
    if (!IsInstalled()) GTEST_SKIP() << "no idiff and oiiotool here";
    int pairs = 0;
    for (std::uint64_t seed = 1; pairs < 50; ++seed, ++pairs) {
        // Floats in [0, 1] and beyond, integers of 8 and 16 bits; grey, colours, alpha.
        const int kind = int(seed % 5);
        const int channels = kind == 0 ? 1 : kind == 4 ? 4 : 3;
        const double scale = kind == 1 && seed % 2 == 0 ? 17 : 1;
        const std::string n = std::to_string(seed);
        Write("t" + n + ".exr", channels, scale, seed, 0, seed);
        Write("c" + n + ".exr", channels, scale, seed, 0.02 + 0.01 * double(seed % 7),
              seed + 100);
        if (kind == 1) {
            ExpectTheSame("c" + n + ".exr", "t" + n + ".exr");
            continue;
        }
        const std::string depth = kind == 2 ? "uint16" : "uint8";
        const std::string ending = kind == 3 ? ".tif" : ".png";
        std::string command = "oiiotool";
        for (const char* side : {"c", "t"}) {
            command += " " + Path(side + n + ".exr").string() + " -d " + depth + " -o " +
                       Path(side + n + ending).string();
        }
        ASSERT_EQ(OutputOf(command), "");
        ExpectTheSame("c" + n + ending, "t" + n + ending);
    }
}

}  // namespace
}  // namespace plumb
