#include "base/thread_pool.h"

#include <candela/error.h>
#include <candela/threads.h>

#include <unistd.h>

#include <algorithm>
#include <exception>
#include <string>
#include <system_error>

namespace candela {

namespace {

// Whether this thread runs the body of a loop.
thread_local bool insideLoop = false;

class InsideLoop {
  public:
    InsideLoop() { insideLoop = true; }
    InsideLoop(const InsideLoop&) = delete;
    InsideLoop& operator=(const InsideLoop&) = delete;
    ~InsideLoop() { insideLoop = false; }
};

// The shared pool; `size` 0 stands for the number of available threads.
struct SharedPool {
    std::mutex mutex;
    std::shared_ptr<ThreadPool> pool;
    unsigned size = 0;
};

SharedPool& sharedPool() {
    static SharedPool pool;
    return pool;
}

}  // namespace

// A call of `run`.
struct ThreadPool::Loop {
    Loop(const Body& loopBody, std::size_t indices) : body(loopBody), count(indices) {}

    const Body& body;
    std::size_t count;
    std::atomic<std::size_t> next{0};
    std::size_t helpers = 0;       // Pool threads inside; guarded by the pool's mutex.
    std::exception_ptr exception;  // Guarded by the pool's mutex.

    bool finished() const { return next.load(std::memory_order_relaxed) >= count; }

    // Runs iterations until none is left or `leave()` says so.
    template <typename Leave>
    void advance(unsigned worker, std::mutex& mutex, const Leave& leave) noexcept {
        const InsideLoop inside;
        for (std::size_t index = next++; index < count; index = next++) {
            try {
                body(index, worker);
            } catch (...) {
                const std::lock_guard lock(mutex);
                if (!exception) exception = std::current_exception();
                next = count;
            }
            if (leave()) return;
        }
    }
};

ThreadPool::ThreadPool(unsigned size) : process_(getpid()) {
    try {
        threads_.reserve(size);
        for (unsigned worker = 1; worker < size; ++worker)
            threads_.emplace_back([this, worker] { work(worker); });
    } catch (const std::system_error&) {
        // The system gives no more threads; the existing ones do the work.
    }
}

ThreadPool::~ThreadPool() {
    if (getpid() != process_) {
        // A forked process has none of the threads.
        for (std::thread& thread : threads_) thread.detach();
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    started_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void ThreadPool::run(std::size_t count, const Body& body) {
    if (count <= 1 || threads_.empty() || insideLoop || getpid() != process_) {
        for (std::size_t index = 0; index < count; ++index) body(index, 0);
        return;
    }
    Loop loop(body, count);
    {
        const std::lock_guard lock(mutex_);
        loops_.push_back(&loop);
        ++startCount_;
    }
    started_.notify_all();
    loop.advance(0, mutex_, [] { return false; });
    std::unique_lock lock(mutex_);
    std::erase(loops_, &loop);
    ended_.wait(lock, [&] { return loop.helpers == 0; });
    lock.unlock();
    if (loop.exception) std::rethrow_exception(loop.exception);
}

ThreadPool::Loop* ThreadPool::newestUnfinished() const {
    for (auto loop = loops_.rbegin(); loop != loops_.rend(); ++loop) {
        if (!(*loop)->finished()) return *loop;
    }
    return nullptr;
}

void ThreadPool::work(unsigned worker) {
    std::unique_lock lock(mutex_);
    for (;;) {
        Loop* loop = nullptr;
        started_.wait(lock, [&] { return stopping_ || (loop = newestUnfinished()) != nullptr; });
        if (stopping_) return;
        ++loop->helpers;
        const std::uint64_t seen = startCount_;
        lock.unlock();
        loop->advance(worker, mutex_, [&] { return startCount_ != seen; });
        lock.lock();
        if (--loop->helpers == 0) ended_.notify_all();
    }
}

std::shared_ptr<ThreadPool> ThreadPool::shared() {
    SharedPool& shared = sharedPool();
    const std::lock_guard lock(shared.mutex);
    if (!shared.pool)
        shared.pool = std::make_shared<ThreadPool>(shared.size != 0 ? shared.size : availableThreads());
    return shared.pool;
}

void setThreadCount(unsigned count) {
    if (count > maxThreadCount) {
        throw Error(ErrorKind::badInput, {},
                    "the number of threads must be 0 (automatic) to " + std::to_string(maxThreadCount) +
                        ", not " + std::to_string(count));
    }
    SharedPool& shared = sharedPool();
    std::shared_ptr<ThreadPool> old;  // Its threads end outside the lock.
    const std::lock_guard lock(shared.mutex);
    if (shared.pool && count != shared.size) old.swap(shared.pool);
    shared.size = count;
}

unsigned threadCount() {
    SharedPool& shared = sharedPool();
    const std::lock_guard lock(shared.mutex);
    return shared.size != 0 ? shared.size : availableThreads();
}

}  // namespace candela
