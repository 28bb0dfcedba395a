#include "score/relative_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace plumb {
namespace {

const RelativeForm& Form(const std::string& key) {
    for (const RelativeForm& form : RelativeForms())
        if (form.key == key) return form;
    throw std::logic_error(key);
}

double ScoreOf(const std::string& key, double s = 0) {
    const Channels c{Image<float>(1, 1, 0.75F)}, t{Image<float>(1, 1, 0.25F)};
    const Channels error{Image<float>(1, 1, float(s))};
    return ScoreRelative(Form(key), c, t, error).value;
}

// c = 3/4, t = 1/4, d = 1/2.
TEST(ScoreRelative, EveryFormByHand) {
    EXPECT_NEAR(ScoreOf("relmse"), 0.25 / (0.0625 + 0.01), 1e-12);
    EXPECT_NEAR(ScoreOf("relmse_1e4"), 0.25 / (0.0625 + 0.0001), 1e-12);
    EXPECT_NEAR(ScoreOf("mrse"), 0.25 / (0.26 * 0.26), 1e-12);
    EXPECT_NEAR(ScoreOf("mape"), 0.5 / 0.26, 1e-12);
    EXPECT_NEAR(ScoreOf("smape"), 1.0 / 1.02, 1e-12);
}

TEST(ScoreRelative, TakesOffTheNoiseOfSquares) {
    EXPECT_NEAR(ScoreOf("relmse", 0.25), (0.25 - 0.0625) / 0.0725, 1e-12);
    EXPECT_NEAR(ScoreOf("mrse", 0.25), (0.25 - 0.0625) / (0.26 * 0.26), 1e-12);
    EXPECT_NEAR(ScoreOf("mape", 0.25), ScoreOf("mape"), 1e-15);
}

TEST(ScoreRelative, BlackTruthIsDefined) {
    const Channels c{Image<float>(2, 1, 0.5F)}, t{Image<float>(2, 1, 0.0F)};
    EXPECT_NEAR(ScoreRelative(Form("relmse"), c, t).value, 25, 1e-12);
    EXPECT_EQ(ScoreRelative(Form("relmse"), t, t).value, 0);
}

TEST(RelativeForms, HaveKeysOfTheirOwnAndSayTheirConstant) {
    std::set<std::string> keys;
    for (const RelativeForm& form : RelativeForms()) {
        EXPECT_TRUE(keys.insert(form.key).second) << form.key;
        EXPECT_GT(form.epsilon, 0);
        const double printed = std::stod(form.formula.substr(form.formula.rfind('+') + 1));
        EXPECT_DOUBLE_EQ(printed, form.epsilon) << form.formula;
    }
}

}  // namespace
}  // namespace plumb
