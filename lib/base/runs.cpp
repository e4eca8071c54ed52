#include "base/runs.h"

#include "base/thread_pool.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <mutex>

namespace candela {

void inRuns(std::size_t count, const std::function<void(std::size_t, std::size_t)>& body) {
    if (count == 0) return;
    if (count <= runLength) return body(0, count);
    const std::size_t runs = (count + runLength - 1) / runLength;
    ThreadPool::shared()->run(runs, [&](std::size_t run, unsigned) {
        body(run * runLength, std::min((run + 1) * runLength, count));
    });
}

namespace {

/// Remembers the exception of the lowest index.
class FirstFailure {
  public:
    /// Calls `body(index)`, unless one of a lower index has failed.
    template <typename Body>
    void attempt(std::size_t index, const Body& body) {
        if (index > index_) return;
        try {
            body(index);
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (index > index_) return;
            index_ = index;
            exception_ = std::current_exception();
        }
    }
    void rethrow() const {
        if (exception_) std::rethrow_exception(exception_);
    }

  private:
    std::mutex mutex_;
    std::atomic<std::size_t> index_ = std::numeric_limits<std::size_t>::max();
    std::exception_ptr exception_;
};

}  // namespace

void forEachElement(std::size_t count, const std::function<std::size_t(std::size_t)>& sizeOf,
                    const std::function<void(std::size_t)>& body) {
    for (std::size_t first = 0; first < count;) {
        // A loop within the body of another has one thread, which is too few for a large element.
        if (sizeOf(first) > runLength) {
            body(first++);
            continue;
        }
        std::size_t end = first + 1;
        while (end < count && sizeOf(end) <= runLength) ++end;
        FirstFailure failure;
        ThreadPool::shared()->run(end - first,
                                  [&](std::size_t index, unsigned) { failure.attempt(first + index, body); });
        failure.rethrow();
        first = end;
    }
}

}  // namespace candela
