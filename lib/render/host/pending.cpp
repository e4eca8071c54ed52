#include "render/host/pending.h"

#include "gl/state_guard.h"

#include <candela/error.h>

#include <cstdint>
#include <vector>

namespace candela {

namespace {

constexpr const char* user = "a pending picture";

}  // namespace

template <typename Picture>
Pending<Picture>::Pending(std::shared_ptr<State> state) : state_(std::move(state)) {}
template <typename Picture>
Pending<Picture>::Pending(Pending&&) noexcept = default;
template <typename Picture>
Pending<Picture>& Pending<Picture>::operator=(Pending&&) noexcept = default;
template <typename Picture>
Pending<Picture>::~Pending() = default;

template <typename Picture>
typename Pending<Picture>::State& Pending<Picture>::state() const {
    if (!state_) {
        throw Error(ErrorKind::badInput, "",
                    "a pending picture is used that was moved from or has been taken already");
    }
    state_->binding->requireCurrent(user);
    return *state_;
}

template <typename Picture>
bool Pending<Picture>::ready() const {
    return state().isReady();
}

template <typename Picture>
Picture Pending<Picture>::get() {
    State& state = this->state();
    const gl::StateGuard guard(*state.binding, user);
    Picture picture = state.take();
    state_.reset();
    return picture;
}

template class CANDELA_API Pending<std::vector<std::uint8_t>>;
template class CANDELA_API Pending<HdrImage>;

}  // namespace candela
