#pragma once

#include <candela/error.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace candela {

// What the streams of candela/image_stream.h share.

template <typename State>
State& requireOpen(State* state) {
    if (state != nullptr) return *state;
    throw Error(ErrorKind::badInput, "",
                "a picture is written to that is finished already, has failed or was moved from");
}

/// Calls `body`. What it throws ends the stream.
template <typename State, typename Body>
void orEnd(std::unique_ptr<State>& state, const Body& body) {
    try {
        body();
    } catch (...) {
        state.reset();
        throw;
    }
}

/// Refuses, as badInput, what is no number of whole rows of `perRow` values, or more than are left.
inline void requireRows(const std::string& name, std::size_t values, std::size_t perRow,
                        std::uint64_t rowsLeft) {
    if (values % perRow == 0 && values / perRow <= rowsLeft) return;
    throw Error(ErrorKind::badInput, name,
                std::to_string(values) + " values are written where " + std::to_string(rowsLeft) +
                    " rows of " + std::to_string(perRow) + " are left; whole rows were expected");
}

/// Refuses to end a picture that is not whole.
inline void requireNoRowsLeft(const std::string& name, std::uint64_t rowsLeft) {
    if (rowsLeft == 0) return;
    throw Error(ErrorKind::badInput, name,
                std::to_string(rowsLeft) + " rows of the picture have not been written");
}

}  // namespace candela
