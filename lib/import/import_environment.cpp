#include "import/abi_import.h"

#include <cstring>

namespace candela {

namespace {

/// The colours of a picture whose numbers are finite.
void requireRadiance(const AbiReader& element, const Image& picture) {
    for (std::size_t texel = 0; texel < picture.pixels.size() / texelSize(picture.format); ++texel) {
        float color[3];
        std::memcpy(color, picture.pixels.data() + texel * texelSize(picture.format), sizeof color);
        for (const float channel : color) {
            if (channel >= 0.0f) continue;
            element.refuse(joined("the texel in row ", texel / picture.width, ", column ",
                                  texel % picture.width, " holds ", channel, ", but 0 or more was expected"));
        }
    }
}

}  // namespace

Environment environmentFrom(const candela_environment& source, const AbiReader& element) {
    candela_image picture{};
    picture.struct_size = sizeof picture;
    picture.width = source.width;
    picture.height = source.height;
    picture.format = CANDELA_PIXELS_RGBA32F;
    picture.pixels = source.pixels;
    picture.pixels_size = source.pixels_size;
    Environment environment;
    environment.picture = imageFrom(picture, element);
    requireRadiance(element, environment.picture);
    environment.rotation = element.unitQuaternion("rotation", source.rotation);
    environment.intensity = element.zeroOrMore("intensity", source.intensity);
    environment.isBackground = !element.flag("is_hidden", source.is_hidden);
    const float distance = element.zeroOrMore("occlusion_distance", source.occlusion_distance);
    if (distance > 0.0f) environment.occlusionDistance = distance;
    return environment;
}

}  // namespace candela
