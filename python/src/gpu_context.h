#pragma once

#include <candela/context.h>

#include <nanobind/nanobind.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include <sys/types.h>

/// OpenGL contexts among the threads and processes of Python. Every call makes its context current on the
/// calling thread and puts back what was current there, so that any thread may call; calls on one context run
/// one after the other. A forked process can use no context of its parent.
namespace candela::python {

namespace nb = nanobind;

struct ContextData {
    pid_t process;
    std::optional<Context> context;       ///< None after `close`.
    std::mutex mutex;                     ///< Held while it is used; never waited for with the GIL.
    std::atomic<std::thread::id> user{};  ///< The thread that holds it.
    std::mutex discardedMutex;
    std::vector<std::function<void()>> discarded;  ///< What is to be destroyed when the context is free.

    explicit ContextData(const DeviceOptions& options);
    ContextData();  ///< Adopts the context of the host.
    ContextData(const ContextData&) = delete;
    ContextData& operator=(const ContextData&) = delete;
    ~ContextData();

    void emptyDiscarded();
    /// Frees it; what was created for it can not be used any more. `discard` is called while no thread uses
    /// the context. Throws `Error` (badInput) when this thread does.
    void close(const std::function<void()>& discard = {});
};

using ContextPtr = std::shared_ptr<ContextData>;

/// Throws `Error` (environment) in a process that was forked from one that has used OpenGL.
void requireOwnProcess();

/// Uses a context: the GIL is released and the context is current until the end of the scope.
class Session {
  public:
    /// `user`: what is used, such as "Renderer". Throws `Error`: environment in another process, badInput
    /// when the context is closed, or this thread uses it already: a callback or a signal handler of a call
    /// does.
    Session(const ContextPtr& context, const char* user);
    /// The same without waiting: where another thread uses the context, the session is false.
    Session(const ContextPtr& context, const char* user, std::try_to_lock_t);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    ~Session();

    explicit operator bool() const { return lock_.owns_lock(); }
    const Context& context() const { return *data_->context; }

  private:
    static ContextPtr checked(const ContextPtr& context, const char* user);
    void enter(const char* user);

    ContextPtr data_;
    nb::gil_scoped_release release_;
    std::unique_lock<std::mutex> lock_;
    std::optional<CurrentContextScope> current_;
};

/// An object of a context. Its destructor waits for nobody: where another thread uses the context, that
/// thread destroys it, and a forked process leaves it alone.
template <typename T>
class ContextObject {
  public:
    explicit ContextObject(ContextPtr context) : context_(std::move(context)) {}
    ContextObject(const ContextObject&) = delete;
    ContextObject& operator=(const ContextObject&) = delete;
    ~ContextObject() { discard(); }

    template <typename... Args>
    T& emplace(Args&&... args) {
        auto made = std::make_shared<T>(std::forward<Args>(args)...);
        discard();
        object_ = std::move(made);
        return *object_;
    }
    explicit operator bool() const { return object_ != nullptr; }
    T& operator*() const { return *object_; }
    T* operator->() const { return object_.get(); }
    void discard();

  private:
    ContextPtr context_;
    std::shared_ptr<T> object_;
};

bool isOwnProcess(pid_t process);

template <typename T>
void ContextObject<T>::discard() {
    if (!object_) return;
    if (!isOwnProcess(context_->process)) {
        new std::shared_ptr<T>(std::move(object_));  // Its memory belongs to the process that ends anyway.
        return;
    }
    // The context is held by the caller where this happens inside of a session.
    const std::lock_guard lock(context_->discardedMutex);
    context_->discarded.push_back([object = std::move(object_)] {});
    object_.reset();
}

/// Destroys what was discarded, if no thread uses the context.
void tidy(const ContextPtr& context);

}  // namespace candela::python
