#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

/// Threads that encode pictures while others are drawn. What waits is bounded, so that memory is.
class EncoderPool {
  public:
    /// Encodes a picture and writes it. Must not throw.
    using Job = std::function<void()>;

    /// `threads`: 1 or more. `maxBytes`: the most that pictures take which wait or are being encoded; one
    /// picture may take more.
    EncoderPool(unsigned threads, std::size_t maxBytes);
    EncoderPool(const EncoderPool&) = delete;
    EncoderPool& operator=(const EncoderPool&) = delete;
    /// Finishes first.
    ~EncoderPool();

    /// Adds a picture that takes `bytes`. Waits while two pictures a thread, or too many bytes, are held.
    /// Jobs start in the order in which they were added.
    void add(std::size_t bytes, Job job);
    /// Waits until every picture is done.
    void finish();

  private:
    struct Entry {
        std::size_t bytes;
        Job job;
    };

    void work();
    bool hasRoom(std::size_t bytes) const;

    const std::size_t maxBytes_, maxPictures_;
    std::mutex mutex_;
    std::condition_variable added_, ended_;
    std::deque<Entry> waiting_;
    std::size_t pictures_ = 0, bytes_ = 0;  ///< That wait or are being encoded.
    bool stopping_ = false;
    std::vector<std::thread> threads_;
};
