// plumb truth from the command line to its files, against closed forms: a run that stopped and
// went on, and every channel's value, error and interval.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "io/image_io.h"
#include "reports/text.h"
#include "tests/io/temp_folder.h"
#include "tests/reports/page_reader.h"

namespace plumb {
namespace {

constexpr double kDepth = 1.2;  // h of a cap of the unit sphere: the bowl.
constexpr double kRho = 0.5;    // Of E(rho).
constexpr std::array<double, 3> kAlbedo{0.5, 0.25, 0.75}, kSky{2, 1, 4};
constexpr int kWidth = 56, kHeight = 44;
constexpr double kPixels = kWidth * kHeight;

class TruthCommand : public TempFolder {
  protected:
    // Half the chords of a bowl of 768 x 192 faces, looking inward, seen from above.
    void PutBowl() const {
        constexpr int kRound = 768, kRings = 192;
        const double psi = std::acos(1 - kDepth), pi = std::numbers::pi;
        std::ostringstream obj;
        obj.precision(9);
        for (int j = 0; j <= kRings; ++j) {
            for (int i = 0; i < kRound; ++i) {
                const double phi = 2 * pi * i / kRound, theta = psi * j / kRings;
                obj << "v " << std::sin(theta) * std::cos(phi) << " "
                    << std::sin(theta) * std::sin(phi) << " " << -std::cos(theta) << "\n";
            }
        }
        for (int j = 0; j < kRings; ++j) {
            for (int i = 0; i < kRound; ++i) {
                const int next = (i + 1) % kRound;
                obj << "f " << 1 + i + j * kRound << " " << 1 + next + j * kRound << " "
                    << 1 + next + (j + 1) * kRound << " " << 1 + i + (j + 1) * kRound << "\n";
            }
        }
        Put("bowl.obj", obj.str());
        Put("bowl.json", R"({"meshes": [{"file": "bowl.obj", "up": "z",
                "albedo": [0.5, 0.25, 0.75]}], "sky": [2, 1, 4],
            "cameras": [{"position_m": [0.1, -0.2, 1.5], "target_m": [0, 0, -1],
                         "up": [0, 1, 0], "fov_deg": 25}]})");
    }

    int Run(const std::string& more) const {
        const std::string command =
            std::string("'") + PLUMB_PROGRAM + "' truth '" + Path("bowl.json").string() +
            "' --width 56 --height 44 --bounces 12 --albedo 0.5 --reach 3 --irradiance "
            "--beauty --out '" +
            Path("out").string() + "' --quiet " + more;
        return std::system(command.c_str());
    }

    std::map<std::string, Image<float>> Channels() const {
        std::map<std::string, Image<float>> channels;
        for (NamedChannel& channel : ReadChannels(Path("out") / "truth.exr")) {
            channels.emplace(channel.name, std::move(channel.pixels));
        }
        return channels;
    }
};

double MeanOf(const Image<float>& image) {
    double sum = 0;
    for (const float x : image.Pixels()) sum += x;
    return sum / double(image.Pixels().size());
}

// Expected: on a sphere every point sees every part of it alike, so at every point of the bowl
// V = a = 1 - h/2, E_k = a (1 - a)^k, E(rho) = a / (1 - rho (1 - a)), times the sky's radiance
// with the albedos of the scene; no chord is longer than 2, so within 3 m V is the same; the shading model knows no
// occlusion: rho times the sky.
// What the pixels say of themselves must be true: of 2464 pixels 95 % hold the exact value (own
// error 0.44 %), and (value - exact) / error has mean square 7 / 5, that of Student's t with 7
// degrees of freedom (its own error: kurtosis of 5 degrees gives 0.1). Slack: facets are 2 pi /
// 768 wide, points on them are tilted by up to half of that, which moves V by at most 0.003, both ways
// alike; beside errors of 0.008 that adds under 3 % to the mean square.
TEST_F(TruthCommand, IsTrueOfItselfAfterStoppingAndGoingOn) {
    PutBowl();
    ASSERT_EQ(Run("--spp 128"), 0);
    ASSERT_EQ(Run("--spp 512 --resume"), 0);
    const auto channels = Channels();
    const double a = 1 - kDepth / 2;
    std::map<std::string, double> exact{{"V", a},
                                        {"V_near", a},
                                        {"E_rho0p5", a / (1 - kRho * (1 - a))},
                                        {"under_way", std::pow(1 - a, 13)}};
    for (int k = 1; k <= 12; ++k) exact["E_" + std::to_string(k)] = a * std::pow(1 - a, k);
    const auto check = [&](const std::string& name, const std::string& part, double value) {
        const auto of = [&](const char* which) -> const Image<float>& {
            return channels.at(name + which + part);
        };
        double held = 0, z2 = 0;
        for (std::size_t p = 0; p < std::size_t(kPixels); ++p) {
            const double x = of("").Pixels()[p], error = of(".error").Pixels()[p];
            const double low = of(".low").Pixels()[p], high = of(".high").Pixels()[p];
            ASSERT_LE(low, x) << name << part;
            ASSERT_GE(high, x) << name << part;
            held += low <= value && value <= high;
            z2 += std::pow((x - value) / error, 2);
        }
        // From E_6 on these are rare: 205 * 0.6^k expected counts of 512, 9.6 to 0.4. A single value's
        // intervals are of whole counts and stray by 3 %; below 2 most allow not to be seen at all.
        const double expected = value * 512;
        EXPECT_GE(held / kPixels, expected >= 12 ? 0.93 : 0.92) << name << part;
        if (expected >= 2) {
            EXPECT_LE(held / kPixels, expected >= 12 ? 0.965 : 0.985) << name << part;
        }
        if (expected >= 100) {
            EXPECT_NEAR(z2 / kPixels, 7.0 / 5, 0.2) << name << part;
        }
        // All pixels together: 4 standard errors of their mean, and a slack of second order.
        EXPECT_NEAR(MeanOf(of("")), value, 4 * std::sqrt(value / 512 / kPixels) + 5e-4 * value)
            << name << part;
    };
    for (const auto& [name, value] : exact) check(name, "", value);
    for (std::size_t c = 0; c < 3; ++c) {
        const std::string part = std::string(".") + "RGB"[c];
        check("irradiance", part, kSky[c] * a / (1 - kAlbedo[c] * (1 - a)));
        for (const float x : channels.at("beauty" + part).Pixels()) {
            EXPECT_NEAR(x, kSky[c] * kAlbedo[c], 1e-6);
        }
        EXPECT_EQ(MeanOf(channels.at("albedo" + part)), kAlbedo[c]);
    }
}

// Expected: the report's figures from the pixels' own, summed here.
TEST_F(TruthCommand, ReportSaysWhatThePixelsSay) {
    PutBowl();
    ASSERT_EQ(Run("--spp 64"), 0);
    const auto channels = Channels();
    const auto json = nlohmann::ordered_json::parse(Get("out/truth.json"));
    EXPECT_EQ(FactIn(json, "spp"), 64);
    EXPECT_EQ(FactIn(json, "pixels_that_show_a_surface"), kWidth * kHeight);
    const Rows page = TableOf(Get("out/truth.html"), {"Quantity"});
    int checked = 0;
    const auto rows = TableIn(json, "quantities")["rows"];
    for (const auto& q : rows) {
        const std::string name = q["name"];
        const std::size_t dot = name.find('.');
        const std::string base = name.substr(0, dot);
        const std::string part = dot == std::string::npos ? "" : name.substr(dot);
        const Image<float>& value = channels.at(name);
        double error2 = 0, below2 = 0, above2 = 0;
        for (std::size_t p = 0; p < value.Pixels().size(); ++p) {
            const double x = value.Pixels()[p];
            error2 += std::pow(channels.at(base + ".error" + part).Pixels()[p], 2);
            below2 += std::pow(x - channels.at(base + ".low" + part).Pixels()[p], 2);
            above2 += std::pow(channels.at(base + ".high" + part).Pixels()[p] - x, 2);
        }
        EXPECT_NEAR(q["mean"], MeanOf(value), 1e-6) << name;
        EXPECT_NEAR(q["rms_standard_error"], std::sqrt(error2 / kPixels), 1e-6) << name;
        EXPECT_NEAR(q["rms_below_95"], std::sqrt(below2 / kPixels), 1e-6) << name;
        EXPECT_NEAR(q["rms_above_95"], std::sqrt(above2 / kPixels), 1e-6) << name;
        ++checked;
        EXPECT_EQ(page.at(std::size_t(checked))[0], name);
        EXPECT_EQ(page.at(std::size_t(checked))[1], Digits(q["mean"].get<double>(), 5));
        EXPECT_EQ(page.at(std::size_t(checked))[2],
                  Digits(q["rms_standard_error"].get<double>()));
    }
    EXPECT_EQ(checked, 1 + 1 + 1 + 12 + 1 + 1 + 3 + 3);  // V, alpha, V_near, E_k, under_way ...
}

}  // namespace
}  // namespace plumb
