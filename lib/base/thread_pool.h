#pragma once

#include <sys/types.h>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace candela {

/// Threads that run the iterations of loops. The calling thread takes part, so that a pool of size 1 has no
/// thread of its own.
///
/// Several threads may run loops on one pool at the same time. Each advances its own loop at least; the other
/// threads prefer the loop that started last. A loop inside of the body of another runs on the thread that
/// meets it.
class ThreadPool {
  public:
    /// `size` threads, 1 or more, the caller included; fewer where the system gives no more.
    explicit ThreadPool(unsigned size);
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;
    ~ThreadPool();

    /// The pool that all parallel work of the library shares, of `threadCount()` threads. `setThreadCount`
    /// replaces it; holders of the old one can still use it.
    static std::shared_ptr<ThreadPool> shared();

    unsigned size() const { return static_cast<unsigned>(threads_.size()) + 1; }

    /// Calls `body(index, worker)` for each index below `count`, in no particular order, and returns when all
    /// calls have ended. `worker`, below `size()`, differs between calls that run at the same time. After an
    /// exception no further index starts, and the first exception is thrown again here.
    using Body = std::function<void(std::size_t index, unsigned worker)>;
    void run(std::size_t count, const Body& body);

  private:
    struct Loop;

    void work(unsigned worker);
    Loop* newestUnfinished() const;

    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::condition_variable started_, ended_;
    std::vector<Loop*> loops_;                  ///< Those under way, in the order in which they started.
    std::atomic<std::uint64_t> startCount_{0};  ///< Of all loops so far.
    bool stopping_ = false;
    pid_t process_;
};

}  // namespace candela
