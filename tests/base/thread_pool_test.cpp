#include "base/thread_pool.h"

#include <candela/error.h>
#include <candela/threads.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace candela {
namespace {

using namespace std::chrono_literals;

TEST(ThreadPool, VisitsEachIndexOnce) {
    for (const unsigned size : {1u, 2u, 5u}) {
        ThreadPool pool(size);
        EXPECT_EQ(pool.size(), size);
        for (const std::size_t count : {0u, 1u, 2u, 1000u}) {
            std::vector<std::atomic<int>> visits(count);
            pool.run(count, [&](std::size_t index, unsigned) { ++visits[index]; });
            for (const std::atomic<int>& visit : visits) EXPECT_EQ(visit, 1);
        }
    }
}

TEST(ThreadPool, GivesEachThreadAWorkerOfItsOwn) {
    ThreadPool pool(4);
    std::vector<std::atomic<int>> inside(pool.size());
    std::atomic<bool> clash = false;
    pool.run(10'000, [&](std::size_t, unsigned worker) {
        if (inside.at(worker)++ != 0) clash = true;
        --inside[worker];
    });
    EXPECT_FALSE(clash);
}

TEST(ThreadPool, UsesItsThreads) {
    ThreadPool pool(3);
    std::atomic<unsigned> arrived = 0;
    // Ends only when three threads are inside at the same time.
    pool.run(3, [&](std::size_t, unsigned) {
        ++arrived;
        while (arrived < 3) std::this_thread::yield();
    });
    EXPECT_EQ(arrived, 3u);
}

TEST(ThreadPool, ThrowsTheExceptionOfABodyInTheCaller) {
    for (const unsigned size : {1u, 4u}) {
        ThreadPool pool(size);
        std::atomic<int> calls = 0;
        try {
            pool.run(100'000, [&](std::size_t index, unsigned) {
                ++calls;
                if (index == 10) throw std::runtime_error("ten");
            });
            FAIL() << "nothing was thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "ten");
        }
        EXPECT_LT(calls, 100'000);
        // The pool is still usable.
        std::atomic<int> sum = 0;
        pool.run(100, [&](std::size_t index, unsigned) { sum += static_cast<int>(index); });
        EXPECT_EQ(sum, 4950);
    }
}

TEST(ThreadPool, ThrowsOneOfManyExceptions) {
    ThreadPool pool(4);
    for (int round = 0; round < 100; ++round)
        EXPECT_THROW(pool.run(8, [](std::size_t, unsigned) { throw std::bad_alloc(); }), std::bad_alloc);
}

TEST(ThreadPool, RunsANestedLoopOnTheSameThread) {
    ThreadPool pool(4);
    std::atomic<int> calls = 0;
    std::atomic<bool> moved = false;
    pool.run(16, [&](std::size_t, unsigned) {
        const std::thread::id outer = std::this_thread::get_id();
        pool.run(16, [&](std::size_t, unsigned worker) {
            if (std::this_thread::get_id() != outer || worker != 0) moved = true;
            ++calls;
        });
    });
    EXPECT_EQ(calls, 256);
    EXPECT_FALSE(moved);
}

TEST(ThreadPool, ForwardsExceptionsOfANestedLoop) {
    ThreadPool pool(4);
    const auto nested = [&](std::size_t, unsigned) {
        pool.run(4, [](std::size_t, unsigned) { throw std::runtime_error("inner"); });
    };
    EXPECT_THROW(pool.run(16, nested), std::runtime_error);
}

TEST(ThreadPool, ServesSeveralCallers) {
    ThreadPool pool(3);
    std::vector<std::uint64_t> sums(4);
    std::vector<std::thread> callers;
    for (std::uint64_t& sum : sums) {
        callers.emplace_back([&] {
            for (int round = 0; round < 200; ++round) {
                std::atomic<std::uint64_t> total = 0;
                pool.run(100, [&](std::size_t index, unsigned) { total += index; });
                sum += total;
            }
        });
    }
    for (std::thread& caller : callers) caller.join();
    for (const std::uint64_t sum : sums) EXPECT_EQ(sum, 200u * 4950u);
}

TEST(ThreadPool, AdvancesALoopWhileAnotherRuns) {
    ThreadPool pool(2);
    std::atomic<bool> release = false;
    std::atomic<int> started = 0;
    std::thread slow([&] {
        pool.run(2, [&](std::size_t, unsigned) {
            ++started;
            while (!release) std::this_thread::sleep_for(1ms);
        });
    });
    while (started < 2) std::this_thread::sleep_for(1ms);
    int calls = 0;
    const std::thread::id own = std::this_thread::get_id();
    // Ends although every other thread of the pool is busy with the slow loop.
    pool.run(10, [&](std::size_t, unsigned) {
        if (std::this_thread::get_id() == own) ++calls;
    });
    release = true;
    slow.join();
    EXPECT_EQ(calls, 10);
}

TEST(SharedThreadPool, HasTheSizeThatIsSet) {
    setThreadCount(3);
    EXPECT_EQ(threadCount(), 3u);
    const std::shared_ptr<ThreadPool> three = ThreadPool::shared();
    EXPECT_EQ(three->size(), 3u);
    EXPECT_EQ(ThreadPool::shared(), three);
    setThreadCount(1);
    EXPECT_EQ(ThreadPool::shared()->size(), 1u);
    // Holders of the old pool can still use it.
    std::atomic<int> calls = 0;
    three->run(100, [&](std::size_t, unsigned) { ++calls; });
    EXPECT_EQ(calls, 100);
    setThreadCount(0);
    EXPECT_EQ(threadCount(), availableThreads());
    EXPECT_EQ(ThreadPool::shared()->size(), availableThreads());
}

TEST(SharedThreadPool, RejectsMoreThanTheMaximum) {
    try {
        setThreadCount(maxThreadCount + 1);
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::badInput);
        EXPECT_STREQ(error.what(), "the number of threads must be 0 (automatic) to 1024, not 1025");
    }
    EXPECT_EQ(threadCount(), availableThreads());
}

}  // namespace
}  // namespace candela
