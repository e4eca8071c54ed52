#pragma once

#include <array>

#include "../common/decoders.h"
#include "texture_info.h"

namespace candela_obj {

using candela_importers::Picture;

/// Where one channel of a picture that is put together comes from: a picture's channel, or a constant.
struct ChannelSource {
    const Picture* picture = nullptr;
    Channel channel = Channel::red;
    float constant = 1.0f;  ///< 0 to 1; counts without a picture.
};

/// A picture of four channels from several pictures, as large as the largest: others are stretched to it,
/// each texel taking the nearest. 16 bits a sample where one of the pictures has them.
Picture combined(const std::array<ChannelSource, 4>& sources);

/// The channel that a single number is taken from where none is named: alpha, where the picture is not opaque
/// all over, and else its luminance.
Channel maskChannel(const Picture& picture);

}  // namespace candela_obj
