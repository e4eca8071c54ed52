#pragma once

#include <candela/export.h>
#include <candela/frame_data.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace candela {

/// A picture on its way from the device (`Frame::readDisplayPicture`, `Frame::readRadiance`): an own copy, so
/// that its renderer may draw the next frame meanwhile. `Picture` is `std::vector<std::uint8_t>` or
/// `HdrImage`. Every function throws `Error`: environment when the context is not current on the calling
/// thread, badInput after a move and once the picture has been taken.
template <typename Picture>
class CANDELA_API Pending {
  public:
    Pending(Pending&&) noexcept;
    Pending& operator=(Pending&&) noexcept;
    /// Ends the transfer of a picture that was not taken. The context has to be current then.
    ~Pending();

    /// Whether `get` would return at once. Never waits.
    bool ready() const;
    /// Waits, and takes the picture: equal, bit for bit, to what the function of `Frame` that waits returns.
    Picture get();

    struct State;  ///< Private to the library.
    explicit Pending(std::shared_ptr<State> state);

  private:
    State& state() const;
    std::shared_ptr<State> state_;
};

using PendingPicture = Pending<std::vector<std::uint8_t>>;  ///< 8-bit RGBA, rows from the top.
using PendingRadiance = Pending<HdrImage>;

}  // namespace candela
