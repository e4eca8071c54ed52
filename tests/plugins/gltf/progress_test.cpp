#include <gtest/gtest.h>

#include <algorithm>

#include "loading.h"

namespace candela_test {
namespace {

TEST(Progress, increasesFromZeroToOne) {
    const TemporaryFolder folder;
    std::vector<double> reported;
    const auto report = [&](double fraction) {
        reported.push_back(fraction);
        return true;
    };
    candela::importScene(plugins(), folder.write("a.gltf", triangleFile().text()),
                         {candela::Strictness::tolerant, report});
    ASSERT_GE(reported.size(), 2u);
    EXPECT_EQ(reported.front(), 0.0);
    EXPECT_EQ(reported.back(), 1.0);
    EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
}

TEST(Progress, everyStepCanBeCancelled) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.gltf", triangleFile().text());
    int steps = 0;
    candela::importScene(plugins(), path,
                         {candela::Strictness::tolerant, [&](double) { return ++steps > 0; }});
    for (int last = 0; last < steps; ++last) {
        int calls = 0;
        try {
            candela::importScene(plugins(), path,
                                 {candela::Strictness::tolerant, [&](double) { return calls++ < last; }});
            ADD_FAILURE() << "not cancelled at step " << last;
        } catch (const candela::Error& error) {
            EXPECT_EQ(error.kind(), candela::ErrorKind::cancelled);
        }
        EXPECT_EQ(calls, last + 1) << "the import continued after being cancelled";
    }
}

}  // namespace
}  // namespace candela_test
