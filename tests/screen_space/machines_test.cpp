// The bits of SAO do not depend on the machine: each kind of vectors that this one has gives the
// same picture.
#include <gtest/gtest.h>
#include <hwy/highway.h>
#include <hwy/targets.h>

#include "screen_space/sao/sao_presets.h"
#include "tests/screen_space/made_gbuffers.h"
#include "tests/screen_space/sao_pictures.h"

namespace plumb {
namespace {

class Machines : public testing::Test {
  protected:
    ~Machines() override { Use(0); }

    /// 0 = the best there is.
    static void Use(std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
};

TEST_F(Machines, GiveTheSameBits) {
    const auto low = [](const Vec3& P) { return P.y() < 1.2; };
    const GBuffer g =
        MadeGBuffer(MadeView(301, 203, 0.5, 7),
                    Union(Union(MadePlane({0.1, 1, 0}, -1), MadePlane({0.2, 0.1, 1}, -5, low)),
                          MadeSphere({0.4, -0.3, -4}, 0.5)));
    std::vector<SaoPreset> presets = SaoPresets();
    presets.push_back({"other options", SaoPaper()});
    TapOptions& taps = presets.back().options.sampling.taps;
    taps.place = TapPlace::kLevelTexel;
    taps.phi = PhiArithmetic::kReduced;
    taps.hash = HashReading::kXorFirst;
    std::vector<SaoPictures> best;
    for (const SaoPreset& preset : presets) best.push_back(PicturesOf(g, preset.options));
    const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
    EXPECT_GT(targets.size(), 1u);
    for (const std::int64_t target : targets) {
        Use(target);
        for (std::size_t k = 0; k < presets.size(); ++k) {
            const SaoPictures passes = PicturesOf(g, presets[k].options);
            const std::string what = presets[k].name + " on " + hwy::TargetName(target);
            EXPECT_TRUE(passes.raw == best[k].raw) << what;
            EXPECT_TRUE(passes.quad == best[k].quad) << what;
            EXPECT_TRUE(passes.packed == best[k].packed) << what;
            EXPECT_TRUE(passes.blur_x == best[k].blur_x) << what;
            EXPECT_TRUE(passes.blur_y == best[k].blur_y) << what;
        }
    }
}

}  // namespace
}  // namespace plumb
