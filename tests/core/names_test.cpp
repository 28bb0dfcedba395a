// Names looked up in a list: distances by hand, and the one form of the message.
#include "core/names.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb {
namespace {

const std::vector<std::string> kNames{"hbao", "gtao", "bitmask"};

// Expected by hand: the fewest letters put in, taken out, replaced or swapped.
TEST(EditDistance, CountsLetters) {
    EXPECT_EQ(EditDistance("", ""), 0);
    EXPECT_EQ(EditDistance("", "abc"), 3);
    EXPECT_EQ(EditDistance("gtao", "gtao"), 0);
    EXPECT_EQ(EditDistance("gtoa", "gtao"), 1);   // swapped
    EXPECT_EQ(EditDistance("gta", "gtao"), 1);    // left out
    EXPECT_EQ(EditDistance("gxtao", "gtao"), 1);  // put in
    EXPECT_EQ(EditDistance("hbao", "gtao"), 2);   // replaced
    EXPECT_EQ(EditDistance("kitten", "sitting"), 3);
    EXPECT_EQ(EditDistance("sitting", "kitten"), 3);
}

std::string Complaint(std::string_view given) {
    try {
        PlaceOf(given, kNames, "technique = " + std::string(given));
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

TEST(PlaceOf, FindsOrSaysWhatThereIsAndWhatIsNear) {
    EXPECT_EQ(PlaceOf("gtao", kNames, ""), 1u);
    EXPECT_EQ(Complaint("gtoa"),
              "technique = gtoa, must be one of hbao, gtao, bitmask; did you mean gtao?");
    EXPECT_EQ(Complaint("bitmaks"),
              "technique = bitmaks, must be one of hbao, gtao, bitmask; did you mean bitmask?");
    // Two letters of four are not near.
    EXPECT_EQ(Complaint("ssao"), "technique = ssao, must be one of hbao, gtao, bitmask");
    EXPECT_EQ(Complaint(""), "technique = , must be one of hbao, gtao, bitmask");
    EXPECT_EQ(MustBeOneOf("x", {}), "must be one of ");
}

TEST(FindNamed, LooksUpByAField) {
    struct Kind {
        std::string_view name;
        int value;
    };
    const Kind kinds[] = {{"one", 1}, {"two", 2}};
    const auto name = [](const Kind& kind) { return kind.name; };
    EXPECT_EQ(FindNamed(kinds, name, "two", "kind = two").value, 2);
    EXPECT_THROW(FindNamed(kinds, name, "three", "kind = three"), Error);
}

}  // namespace
}  // namespace plumb
