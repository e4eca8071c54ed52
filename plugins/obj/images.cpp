#include "images.h"

#include "../common/push_picture.h"

namespace candela_obj {
namespace {

using candela_importers::decodeJpeg;
using candela_importers::decodePng;
using candela_importers::isJpeg;
using candela_importers::isPng;
using candela_importers::pushPicture;

/// Tells made pictures apart. No path holds a line break: a statement is one line.
std::string partOf(const TextureInfo* texture) {
    if (!texture) return "\n";
    return texture->file + "\n" + std::to_string(static_cast<int>(texture->channel)) + "\n";
}

Channel channelOr(const TextureInfo& texture, Channel usual) {
    return texture.channel == Channel::usual ? usual : texture.channel;
}

}  // namespace

std::optional<Picture> Images::decode(const TextureInfo* texture) {
    if (!texture || leftOut_.contains(texture->file)) return std::nullopt;
    const Bytes file = host_.readFile(texture->file);
    const std::string element = texture->element + " '" + readable(texture->file) + "'";
    if (isPng(file)) return decodePng(file, element);
    if (isJpeg(file)) return decodeJpeg(file, element);
    host_.note(element + " is neither a PNG nor a JPEG file: left out");
    leftOut_.insert(texture->file);
    return std::nullopt;
}

std::int32_t Images::whole(const TextureInfo* texture) {
    if (!texture) return -1;
    const auto known = pushed_.find(texture->file);
    if (known != pushed_.end()) return known->second;
    const std::optional<Picture> picture = decode(texture);
    if (!picture) return -1;
    return pushed_[texture->file] = pushPicture(texture->file, *picture, host_);
}

std::int32_t Images::colorAndMask(const TextureInfo* color, const TextureInfo* mask) {
    if (!mask) return whole(color);
    const std::string key = "mask\n" + partOf(color) + partOf(mask);
    const auto known = pushed_.find(key);
    if (known != pushed_.end()) return known->second;
    const std::optional<Picture> maskPicture = decode(mask);
    if (!maskPicture) return whole(color);
    const std::optional<Picture> colorPicture = decode(color);
    const Picture* const rgb = colorPicture ? &*colorPicture : nullptr;
    const Channel alpha = channelOr(*mask, maskChannel(*maskPicture));
    const Picture both = combined({{{rgb, Channel::red, 1.0f},
                                    {rgb, Channel::green, 1.0f},
                                    {rgb, Channel::blue, 1.0f},
                                    {&*maskPicture, alpha, 1.0f}}});
    return pushed_[key] = pushPicture(mask->file, both, host_);
}

std::int32_t Images::roughnessAndMetal(const TextureInfo* roughness, const TextureInfo* metal) {
    if (!roughness && !metal) return -1;
    const std::string key = "metal\n" + partOf(roughness) + partOf(metal);
    const auto known = pushed_.find(key);
    if (known != pushed_.end()) return known->second;
    const std::optional<Picture> roughPicture = decode(roughness), metalPicture = decode(metal);
    if (!roughPicture && !metalPicture) return -1;
    std::array<ChannelSource, 4> sources;
    if (roughPicture) sources[1] = {&*roughPicture, channelOr(*roughness, Channel::luminance), 1.0f};
    if (metalPicture) sources[2] = {&*metalPicture, channelOr(*metal, Channel::luminance), 1.0f};
    return pushed_[key] = pushPicture((roughPicture ? roughness : metal)->file, combined(sources), host_);
}

}  // namespace candela_obj
