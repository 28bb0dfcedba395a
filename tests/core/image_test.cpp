#include "core/image.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(Image, KeepsPixelsRowByRow) {
    Image<int> image(3, 2);
    image(2, 0) = 5;
    image(0, 1) = 7;
    EXPECT_EQ(image.Pixels(), (std::vector<int>{0, 0, 5, 7, 0, 0}));
    EXPECT_EQ(image.Width(), 3);
    EXPECT_EQ(image.Height(), 2);
}

TEST(Image, StartsWithTheValueGiven) {
    const Image<float> image(2, 2, 0.5f);
    EXPECT_EQ(image(1, 1), 0.5f);
    EXPECT_FALSE(image.Empty());
    EXPECT_TRUE(Image<float>().Empty());
}

TEST(Image, EqualMeansSameShapeAndPixels) {
    EXPECT_EQ(Image<int>(2, 3, 1), Image<int>(2, 3, 1));
    EXPECT_NE(Image<int>(2, 3, 1), Image<int>(3, 2, 1));
}

}  // namespace
}  // namespace plumb
