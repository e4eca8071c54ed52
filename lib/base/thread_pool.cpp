#include "base/thread_pool.h"

#include <algorithm>

namespace candela {

ThreadPool::ThreadPool(unsigned size) {
    const unsigned workers = size != 0 ? size : std::max(1u, std::thread::hardware_concurrency());
    for (unsigned worker = 1; worker < workers; ++worker)
        threads_.emplace_back([this, worker] { work(worker); });
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    started_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void ThreadPool::run(std::size_t count, const Body& body) {
    {
        const std::lock_guard lock(mutex_);
        body_ = &body;
        count_ = count;
        next_ = 0;
        busy_ = threads_.size();
        ++round_;
    }
    started_.notify_all();
    takeIndices(0);
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [this] { return busy_ == 0; });
}

void ThreadPool::takeIndices(unsigned worker) {
    for (std::size_t index = next_++; index < count_; index = next_++) (*body_)(index, worker);
}

void ThreadPool::work(unsigned worker) {
    std::uint64_t seen = 0;
    std::unique_lock lock(mutex_);
    for (;;) {
        started_.wait(lock, [&] { return stopping_ || round_ != seen; });
        if (stopping_) return;
        seen = round_;
        lock.unlock();
        takeIndices(worker);
        lock.lock();
        if (--busy_ == 0) ended_.notify_one();
    }
}

}  // namespace candela
