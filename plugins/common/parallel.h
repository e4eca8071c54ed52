#pragma once

#include <candela/plugin.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <vector>

namespace candela_plugins {

/// Whether the host (a `candela_host` or `candela_refinement`) runs parallel loops, which came with
/// version 1.2.
template <typename Host>
bool hasParallelLoops(const Host& host) {
    return host.struct_size >= offsetof(Host, parallel_for) + sizeof host.parallel_for;
}

/// The largest number of calls that `parallelFor` runs at the same time; 1 or more.
template <typename Host>
std::uint32_t workerCount(const Host& host) {
    return hasParallelLoops(host) ? host.worker_count : 1;
}

/// Calls `body(index, worker)` for each index below `count` on the threads of the host, in order where the
/// host has no parallel loops. `worker`, below `workerCount(host)`, differs between calls that run at the
/// same time. All calls are made. Of the exceptions that they throw, that of the lowest index is thrown again
/// at the end, whatever the number of threads.
template <typename Host, typename Body>
void parallelFor(const Host& host, std::uint32_t count, const Body& body) {
    struct Context {
        const Body& body;
        std::vector<std::exception_ptr> exceptions;
    } context{body, std::vector<std::exception_ptr>(count)};
    const auto call = [](void* pointer, std::uint32_t index, std::uint32_t worker) {
        Context& loop = *static_cast<Context*>(pointer);
        try {
            loop.body(index, worker);
        } catch (...) {
            loop.exceptions[index] = std::current_exception();
        }
    };
    if (hasParallelLoops(host)) {
        host.parallel_for(host.self, count, call, &context);
    } else {
        for (std::uint32_t index = 0; index < count; ++index) call(&context, index, 0);
    }
    for (const std::exception_ptr& exception : context.exceptions) {
        if (exception) std::rethrow_exception(exception);
    }
}

}  // namespace candela_plugins
