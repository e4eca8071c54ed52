#pragma once

#include "gl/context_binding.h"

#include <candela/pending.h>

#include <functional>
#include <memory>
#include <utility>

namespace candela {

/// How a picture is fetched. Objects of OpenGL live in what the functions have captured.
template <typename Picture>
struct Pending<Picture>::State {
    std::shared_ptr<gl::ContextBinding> binding;
    std::function<bool()> isReady;
    std::function<Picture()> take;
};

template <typename Picture>
Pending<Picture> makePending(const std::shared_ptr<gl::ContextBinding>& binding,
                             std::function<bool()> isReady, std::function<Picture()> take) {
    using State = typename Pending<Picture>::State;
    return Pending<Picture>(std::shared_ptr<State>(new State{binding, std::move(isReady), std::move(take)},
                                                   gl::ContextDeleter<State>{binding, "pending picture"}));
}

}  // namespace candela
