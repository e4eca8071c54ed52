#include "parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace candela_opensubdiv {
namespace {

/// What all threads take their work from.
class Queue {
  public:
    Queue(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work)
        : count_(count), work_(work) {}

    void drain(std::size_t worker) noexcept {
        for (std::size_t i = next_++; i < count_; i = next_++) {
            try {
                work_(i, worker);
            } catch (...) {
                const std::lock_guard lock(mutex_);
                if (failure_ == nullptr) failure_ = std::current_exception();
                next_ = count_;
            }
        }
    }

    void rethrow() const {
        if (failure_ != nullptr) std::rethrow_exception(failure_);
    }

  private:
    std::size_t count_;
    const std::function<void(std::size_t, std::size_t)>& work_;
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_;
    std::exception_ptr failure_;
};

}  // namespace

std::size_t workerCount() {
    return std::max(1u, std::thread::hardware_concurrency());
}

void inParallel(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) {
    Queue queue(count, work);
    {
        std::vector<std::jthread> helpers;
        try {
            while (helpers.size() + 1 < std::min(workerCount(), count)) {
                helpers.emplace_back([&queue, worker = helpers.size() + 1] { queue.drain(worker); });
            }
        } catch (const std::system_error&) {
            // The system gives no more threads: those at hand do the work.
        }
        queue.drain(0);
    }
    queue.rethrow();
}

}  // namespace candela_opensubdiv
