#include "picture_reader.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <png.h>

#include <numeric>
#include <set>
#include <stdexcept>

double PngPicture::mean() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < rgba.size(); ++i) sum += i % 4 == 3 ? 0.0 : rgba[i];
    return sum / (3.0 * width * height);
}

std::size_t PngPicture::colors() const {
    std::set<std::uint32_t> seen;
    for (std::size_t i = 0; i < rgba.size(); i += 4)
        seen.insert(rgba[i] | rgba[i + 1] << 8 | rgba[i + 2] << 16);
    return seen.size();
}

bool PngPicture::opaque() const {
    for (std::size_t i = 3; i < rgba.size(); i += 4)
        if (rgba[i] != 255) return false;
    return true;
}

std::vector<std::string> ExrPicture::names() const {
    std::vector<std::string> result;
    for (const auto& [name, values] : channels) result.push_back(name);
    return result;
}

float ExrPicture::at(const std::string& channel, int x, int y) const {
    return channels.at(channel).at(static_cast<std::size_t>(y * width + x));
}

PngPicture readPng(const std::string& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&image, path.c_str()) == 0)
        throw std::runtime_error(path + ": " + image.message);
    image.format = PNG_FORMAT_RGBA;
    PngPicture picture;
    picture.width = static_cast<int>(image.width);
    picture.height = static_cast<int>(image.height);
    picture.rgba.resize(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr) == 0)
        throw std::runtime_error(path + ": " + image.message);
    return picture;
}

ExrPicture readExr(const std::string& path) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i box = file.header().dataWindow();
    ExrPicture picture;
    picture.width = box.max.x - box.min.x + 1;
    picture.height = box.max.y - box.min.y + 1;
    picture.chromaticities = Imf::hasChromaticities(file.header());
    for (auto attribute = file.header().begin(); attribute != file.header().end(); ++attribute)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute()))
            picture.texts[attribute.name()] = text->value();
    Imf::FrameBuffer target;
    const Imf::ChannelList& channels = file.header().channels();
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
        picture.floats &= channel.channel().type == Imf::FLOAT;
        std::vector<float>& values = picture.channels[channel.name()];
        values.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
        target.insert(channel.name(), Imf::Slice::Make(Imf::FLOAT, values.data(), box));
    }
    file.setFrameBuffer(target);
    file.readPixels(box.min.y, box.max.y);
    return picture;
}
