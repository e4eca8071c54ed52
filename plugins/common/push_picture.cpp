#include "push_picture.h"

namespace candela_importers {

std::int32_t pushPicture(const std::string& name, const Picture& picture, const Host& host) {
    candela_image image{};
    image.struct_size = sizeof image;
    image.name = name.c_str();
    image.width = picture.width;
    image.height = picture.height;
    image.format = picture.sampleSize == SampleSize::bits16 ? CANDELA_PIXELS_RGBA16 : CANDELA_PIXELS_RGBA8;
    image.pixels = picture.pixels.data();
    image.pixels_size = picture.pixels.size();
    return host.add(image);
}

}  // namespace candela_importers
