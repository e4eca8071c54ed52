// Loops over many values, on all cores.

#include "base/runs.h"

#include <candela/threads.h>

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace candela {
namespace {

/// Of several threads, also where the machine has one core.
class RunsTest : public testing::Test {
  protected:
    void SetUp() override { setThreadCount(4); }
    void TearDown() override { setThreadCount(0); }
};

TEST_F(RunsTest, RunsCoverEachNumberOnce) {
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, runLength - 1, runLength, runLength + 1,
                                    3 * runLength, 5 * runLength + 7}) {
        std::vector<unsigned char> visits(count);
        inRuns(count, [&](std::size_t first, std::size_t end) {
            EXPECT_LT(first, end);
            EXPECT_LE(end - first, runLength);
            for (std::size_t i = first; i < end; ++i) ++visits[i];
        });
        EXPECT_EQ(visits, std::vector<unsigned char>(count, 1));
    }
}

TEST_F(RunsTest, OneBrokenValueOfManyIsFoundWhereverItIs) {
    std::vector<int> values(3 * runLength + 5, 1);
    const auto isOne = [](int value) { return value == 1; };
    EXPECT_TRUE(holdsForAll(values, isOne));
    for (const std::size_t place : {std::size_t{0}, runLength - 1, runLength, values.size() - 1}) {
        values[place] = 2;
        EXPECT_FALSE(holdsForAll(values, isOne)) << place;
        values[place] = 1;
    }
    EXPECT_TRUE(holdsForAll(std::vector<int>(), isOne));
}

/// Elements of these sizes, each visited; those in `broken` throw. Returns the index of the exception, or -1.
int firstFailure(const std::vector<std::size_t>& sizes, const std::vector<bool>& broken) {
    try {
        forEachElement(
            sizes.size(), [&](std::size_t i) { return sizes[i]; },
            [&](std::size_t i) {
                if (broken[i]) throw std::runtime_error(std::to_string(i));
            });
    } catch (const std::runtime_error& error) {
        return std::stoi(error.what());
    }
    return -1;
}

TEST_F(RunsTest, EachElementIsVisitedOnce) {
    const std::vector<std::size_t> sizes{5, 2 * runLength, 0, 1, runLength, runLength + 1, runLength + 1, 3};
    std::mutex mutex;
    std::vector<int> visits(sizes.size());
    forEachElement(
        sizes.size(), [&](std::size_t i) { return sizes[i]; },
        [&](std::size_t i) {
            const std::lock_guard lock(mutex);
            ++visits[i];
        });
    EXPECT_EQ(visits, std::vector<int>(sizes.size(), 1));
}

TEST_F(RunsTest, LargeElementsHaveLoopsOnAllCores) {
    // Ends only when two threads are in the loop of the only large element at the same time.
    std::atomic<unsigned> arrived = 0;
    forEachElement(
        2, [](std::size_t i) { return i == 0 ? 2 * runLength : 1; },
        [&](std::size_t i) {
            if (i != 0) return;
            inRuns(2 * runLength, [&](std::size_t, std::size_t) {
                ++arrived;
                while (arrived < 2) std::this_thread::yield();
            });
        });
    EXPECT_EQ(arrived, 2u);
}

TEST_F(RunsTest, TheFirstOfSeveralBrokenElementsIsReported) {
    std::vector<std::size_t> sizes(2000, 1);
    std::vector<bool> broken(sizes.size(), false);
    EXPECT_EQ(firstFailure(sizes, broken), -1);
    for (std::size_t i = 1003; i < broken.size(); ++i) broken[i] = true;
    for (int repetition = 0; repetition < 50; ++repetition) EXPECT_EQ(firstFailure(sizes, broken), 1003);
    sizes[1005] = 2 * runLength;
    EXPECT_EQ(firstFailure(sizes, broken), 1003);
    broken[2] = true;
    sizes[2] = 2 * runLength;
    EXPECT_EQ(firstFailure(sizes, broken), 2);
}

}  // namespace
}  // namespace candela
