#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace candela {

/// Threads that wait for loops to run. The caller's own thread takes part, so that a pool of one has no
/// thread of its own.
class ThreadPool {
  public:
    /// `size` workers, the caller included; 0 stands for one a core.
    explicit ThreadPool(unsigned size = 0);
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;
    ~ThreadPool();

    unsigned size() const { return static_cast<unsigned>(threads_.size()) + 1; }

    /// Calls `body(index, worker)` for each index under `count`, whichever worker (under `size()`) is free,
    /// and returns when all are done. `body` must not throw.
    using Body = std::function<void(std::size_t index, unsigned worker)>;
    void run(std::size_t count, const Body& body);

  private:
    void work(unsigned worker);
    void takeIndices(unsigned worker);

    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::condition_variable started_, ended_;
    const Body* body_ = nullptr;
    std::size_t count_ = 0;
    std::atomic<std::size_t> next_{0};
    std::uint64_t round_ = 0;
    std::size_t busy_ = 0;
    bool stopping_ = false;
};

}  // namespace candela
