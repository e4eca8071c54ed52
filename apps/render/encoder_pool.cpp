#include "encoder_pool.h"

#include <csignal>
#include <system_error>
#include <utility>

namespace {

constexpr std::size_t picturesPerThread = 2;

/// Signals go to the thread that draws, which stops where it can.
void blockSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace

EncoderPool::EncoderPool(unsigned threads, std::size_t maxBytes)
    : maxBytes_(maxBytes), maxPictures_(picturesPerThread * threads) {
    for (unsigned i = 0; i < threads; ++i) {
        try {
            threads_.emplace_back([this] { work(); });
        } catch (const std::system_error&) {
            if (threads_.empty()) throw;
            return;  // The system gives no more: those there are do the work.
        }
    }
}

EncoderPool::~EncoderPool() {
    finish();
    {
        const std::scoped_lock lock(mutex_);
        stopping_ = true;
    }
    added_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

bool EncoderPool::hasRoom(std::size_t bytes) const {
    return pictures_ == 0 || (pictures_ < maxPictures_ && bytes_ + bytes <= maxBytes_);
}

void EncoderPool::add(std::size_t bytes, Job job) {
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [&] { return hasRoom(bytes); });
    waiting_.push_back({bytes, std::move(job)});
    ++pictures_;
    bytes_ += bytes;
    lock.unlock();
    added_.notify_one();
}

void EncoderPool::finish() {
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [&] { return pictures_ == 0; });
}

void EncoderPool::work() {
    blockSignals();
    std::unique_lock lock(mutex_);
    while (true) {
        added_.wait(lock, [&] { return stopping_ || !waiting_.empty(); });
        if (waiting_.empty()) return;
        Entry entry = std::move(waiting_.front());
        waiting_.pop_front();
        lock.unlock();
        entry.job();
        entry.job = nullptr;  // Frees the picture before there is room for another.
        lock.lock();
        --pictures_;
        bytes_ -= entry.bytes;
        ended_.notify_all();
    }
}
