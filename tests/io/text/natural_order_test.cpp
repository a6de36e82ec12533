#include "io/text/natural_order.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace asv::io {
namespace {

TEST(NaturalOrder, CountsRunsOfDigitsAsNumbers) {
    std::vector<std::string> names{"7ASV-x10", "15ASV",     "7ASV-x2", "3ASV",  "7ASV",
                                   "a",        "3ASV-maze", "map2b",   "map2a", "map10"};
    std::sort(names.begin(), names.end(), naturally_before);
    EXPECT_EQ(names, (std::vector<std::string>{"3ASV", "3ASV-maze", "7ASV", "7ASV-x2", "7ASV-x10",
                                               "15ASV", "a", "map2a", "map2b", "map10"}));
}

TEST(NaturalOrder, IsStrictAndTakesAnything) {
    const std::string huge(400, '9');
    const std::vector<std::string> names{"",    "0",  "00",   "3",        "03", "3a",  "03a",
                                         "3ab", "a3", "a03b", huge + "1", huge, "\xFF"};
    for (const std::string& a : names) {
        EXPECT_FALSE(naturally_before(a, a)) << a;
        for (const std::string& b : names) {
            EXPECT_EQ(a == b, naturally_before(a, b) == naturally_before(b, a)) << a << " " << b;
            for (const std::string& c : names) {
                const bool in_order = naturally_before(a, b) && naturally_before(b, c);
                EXPECT_TRUE(!in_order || naturally_before(a, c)) << a << " " << b << " " << c;
            }
        }
    }
    EXPECT_TRUE(naturally_before(huge, huge + "1"));
}

}  // namespace
}  // namespace asv::io
