#include "gpu_context.h"

#include "convert.h"
#include "module.h"

#include <candela/error.h>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <unistd.h>

#include <atomic>

namespace candela::python {

namespace {

// The process that has created a context first; 0: none. Drivers do not survive a fork.
std::atomic<pid_t> glProcess{0};

pid_t enterProcess() {
    requireOwnProcess();
    glProcess = getpid();
    return getpid();
}

}  // namespace

bool isOwnProcess(pid_t process) {
    return process == getpid();
}

void requireOwnProcess() {
    const pid_t first = glProcess;
    if (first == 0 || first == getpid()) return;
    throw Error(
        ErrorKind::environment, "",
        "this process was forked from one that uses OpenGL, whose drivers do not survive a fork: start "
        "processes with multiprocessing.get_context(\"spawn\"), or fork before the first Context or "
        "Renderer");
}

ContextData::ContextData(const DeviceOptions& options)
    : process(enterProcess()), context(Context::createHeadless(options)) {}

ContextData::ContextData() : process(enterProcess()), context(Context::adoptCurrent()) {}

ContextData::~ContextData() {
    if (isOwnProcess(process)) {
        emptyDiscarded();
        return;
    }
    new std::optional<Context>(std::move(context));
    new std::vector<std::function<void()>>(std::move(discarded));
}

void ContextData::emptyDiscarded() {
    std::vector<std::function<void()>> objects;
    {
        const std::lock_guard lock(discardedMutex);
        objects.swap(discarded);
    }
}

void ContextData::close(const std::function<void()>& discard) {
    if (!isOwnProcess(process)) return;
    if (user == std::this_thread::get_id())
        throw Error(ErrorKind::badInput, "", "a context is closed by a callback while a call of it runs");
    const nb::gil_scoped_release release;
    const std::lock_guard lock(mutex);
    if (discard) discard();
    emptyDiscarded();
    context.reset();
}

ContextPtr Session::checked(const ContextPtr& context, const char* user) {
    const auto fail = [user](ErrorKind kind, const char* text) {
        throw Error(kind, "", std::string(user) + text);
    };
    if (!isOwnProcess(context->process)) {
        requireOwnProcess();
        fail(ErrorKind::environment, " belongs to another process");
    }
    if (!context->context) fail(ErrorKind::badInput, " is used after its context was closed");
    if (context->user == std::this_thread::get_id())
        fail(ErrorKind::badInput,
             " is used by a callback or a signal handler while a call of the same context runs");
    return context;
}

Session::Session(const ContextPtr& context, const char* user)
    : data_(checked(context, user)), lock_(data_->mutex) {
    enter(user);
}

Session::Session(const ContextPtr& context, const char* user, std::try_to_lock_t)
    : data_(checked(context, user)), lock_(data_->mutex, std::try_to_lock) {
    if (lock_) enter(user);
}

void Session::enter(const char* user) {
    if (!data_->context)
        throw Error(ErrorKind::badInput, "", std::string(user) + " is used after its context was closed");
    current_.emplace(*data_->context);
    data_->user = std::this_thread::get_id();
    data_->emptyDiscarded();
}

Session::~Session() {
    if (!lock_) return;
    data_->emptyDiscarded();
    data_->user = std::thread::id();
}

void tidy(const ContextPtr& context) {
    if (!isOwnProcess(context->process)) return;
    const std::unique_lock lock(context->mutex, std::try_to_lock);
    if (lock) context->emptyDiscarded();
}

namespace {

ContextPtr create(std::optional<int> device, bool software) {
    requireOwnProcess();
    const nb::gil_scoped_release release;
    const CurrentContextScope scope;  // No thread keeps the new one current.
    return std::make_shared<ContextData>(DeviceOptions{device, software});
}

const Context& opened(const ContextPtr& data) {
    if (!data->context) throw Error(ErrorKind::badInput, "", "the Context is closed");
    return *data->context;
}

nb::list attemptsOf(const std::vector<ContextAttempt>& attempts) {
    nb::list list;
    for (const ContextAttempt& attempt : attempts) list.append(nb::make_tuple(attempt.way, attempt.outcome));
    return list;
}

}  // namespace

/// `Context` in Python.
struct ContextHandle {
    ContextPtr data;
};

ContextPtr contextOf(nb::handle context) {
    if (context.is_none()) return create(std::nullopt, false);
    if (!nb::isinstance<ContextHandle>(context)) failConversion("context", "a Context or None", context);
    return nb::cast<ContextHandle&>(context).data;
}

nb::object contextObject(const ContextPtr& data) {
    return nb::cast(ContextHandle{data});
}

void bindContexts(nb::module_& module) {
    nb::class_<ContextHandle>(module, "Context",
                              "An OpenGL 4.5 context without a window: on a GPU where there is one, else on "
                              "the processor. Any thread may use what is created for it; calls run one after "
                              "the other. It is a context "
                              "manager, and closed at its end.")
        .def(
            "__init__",
            [](ContextHandle* self, std::optional<int> device, bool software) {
                new (self) ContextHandle{create(device, software)};
            },
            nb::kw_only(), nb::arg("device") = nb::none(), nb::arg("software") = false,
            "device: the EGL device of this number and no other (`candela.devices()`). software: devices "
            "that run on the processor only. Raises MachineError that lists every attempt and its reason.")
        .def_static(
            "adopt_current", [] { return ContextHandle{std::make_shared<ContextData>()}; },
            "Takes the context of a host, such as GLFW or moderngl, that is current on this thread. It stays "
            "the host's, and has to be current on the thread of every call.")
        .def_prop_ro(
            "renderer", [](const ContextHandle& self) { return opened(self.data).renderer(); },
            "GL_RENDERER, such as 'llvmpipe (LLVM 15.0.6, 256 bits)'.")
        .def_prop_ro(
            "driver", [](const ContextHandle& self) { return opened(self.data).driver(); },
            "GL_VENDOR and GL_VERSION.")
        .def_prop_ro(
            "is_software", [](const ContextHandle& self) { return opened(self.data).isSoftware(); },
            "Whether it runs on the processor.")
        .def_prop_ro(
            "attempts", [](const ContextHandle& self) { return attemptsOf(opened(self.data).attempts()); },
            nb::sig("def attempts(self) -> list[tuple[str, str]]"),
            "What was tried on the way to it: the way, and the renderer's name or why it failed.")
        .def_prop_ro(
            "closed", [](const ContextHandle& self) { return !self.data->context; },
            "Whether `close` was called.")
        .def(
            "close", [](ContextHandle& self) { self.data->close(); },
            "Ends it: what was created for it raises an error when it is used.")
        .def(
            "__enter__", [](nb::object self) { return self; }, nb::sig("def __enter__(self) -> Context"))
        .def(
            "__exit__", [](ContextHandle& self, nb::args) { self.data->close(); },
            nb::sig("def __exit__(self, *exception: object) -> None"));
}

}  // namespace candela::python
