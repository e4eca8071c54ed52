#include "base/range_pool.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace candela::test {
namespace {

TEST(RangePool, BeginsWithAllGivenAway) {
    RangePool pool(5);
    EXPECT_EQ(pool.capacity(), 5u);
    EXPECT_FALSE(pool.take(1));
    EXPECT_EQ(pool.take(0), 0u);
    EXPECT_EQ(pool.freeAtEnd(), 0u);
}

TEST(RangePool, FreedNeighboursAreOneRange) {
    for (const auto& order : {std::vector{0u, 1u, 2u}, {2u, 1u, 0u}, {0u, 2u, 1u}}) {
        RangePool pool(6);
        for (const unsigned i : order) pool.free(2 * i, 2);
        EXPECT_EQ(pool.freeAtEnd(), 6u);
        EXPECT_EQ(pool.take(6), 0u);
    }
}

TEST(RangePool, GrowingJoinsWhatIsFreeAtTheEnd) {
    RangePool pool(4);
    pool.free(3, 1);
    pool.growTo(6);
    EXPECT_EQ(pool.capacity(), 6u);
    EXPECT_EQ(pool.freeAtEnd(), 3u);
    EXPECT_EQ(pool.take(3), 3u);
    EXPECT_FALSE(pool.take(1));
}

TEST(RangePool, NoElementIsGivenAwayTwice) {
    std::mt19937 random(7);
    RangePool pool;
    std::vector<bool> taken;
    struct Range {
        std::uint64_t first, count;
    };
    std::vector<Range> ranges;
    for (int step = 0; step < 5000; ++step) {
        if (random() % 2 == 0 && !ranges.empty()) {
            std::swap(ranges[random() % ranges.size()], ranges.back());
            pool.free(ranges.back().first, ranges.back().count);
            for (std::uint64_t i = 0; i < ranges.back().count; ++i) taken[ranges.back().first + i] = false;
            ranges.pop_back();
            continue;
        }
        const std::uint64_t count = 1 + random() % 9;
        std::optional<std::uint64_t> first = pool.take(count);
        if (!first) {
            pool.growTo(pool.capacity() + count - pool.freeAtEnd());
            taken.resize(pool.capacity());
            first = pool.take(count);
        }
        ASSERT_TRUE(first);
        ASSERT_LE(*first + count, pool.capacity());
        for (std::uint64_t i = 0; i < count; ++i) {
            ASSERT_FALSE(taken[*first + i]);
            taken[*first + i] = true;
        }
        ranges.push_back({*first, count});
    }
    for (const Range& range : ranges) pool.free(range.first, range.count);
    EXPECT_EQ(pool.freeAtEnd(), pool.capacity());
}

}  // namespace
}  // namespace candela::test
