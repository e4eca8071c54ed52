#include "images.h"

#include <cstring>
#include <limits>
#include <optional>
#include <set>

#include "../common/image.h"
#include "specular_glossiness.h"
#include "texture_uses.h"

namespace candela_plugins::gltf {
namespace {

/// Images that are decoded: as they are, and as roughness.
struct ImagesInUse {
    std::vector<bool> plain;
    std::set<std::pair<std::size_t, float>> roughness;
};

ImagesInUse imagesInUse(const Document& document) {
    ImagesInUse used{std::vector<bool>(document.imageSources.size()), {}};
    const auto imageOf = [&](const TextureUse& use) {
        return use.texture < 0 ? -1
                               : document.model.textures.at(static_cast<std::size_t>(use.texture)).source;
    };
    for (const tinygltf::Material& material : document.model.materials) {
        const TextureUses uses = textureUses(material);
        for (const TextureUse& use : uses.all()) {
            if (imageOf(use) >= 0) used.plain.at(static_cast<std::size_t>(imageOf(use))) = true;
        }
        const int glossiness = imageOf(uses.specularGlossiness);
        if (glossiness >= 0)
            used.roughness.emplace(static_cast<std::size_t>(glossiness), glossinessFactor(material));
    }
    return used;
}

/// An image without a name has that of its file.
std::string imageName(const Source& source) {
    const bool hasFile = source.uri && !isDataUri(*source.uri);
    return source.name.empty() && hasFile ? *source.uri : source.name;
}

template <typename Sample>
void glossinessToRoughness(Image& image, float factor) {
    constexpr Sample one = std::numeric_limits<Sample>::max();
    for (std::size_t at = 0; at + 4 * sizeof(Sample) <= image.pixels.size(); at += 4 * sizeof(Sample)) {
        Sample texel[4];
        std::memcpy(texel, &image.pixels[at], sizeof texel);
        const auto roughness =
            static_cast<Sample>(static_cast<float>(one) - factor * static_cast<float>(texel[3]) + 0.5f);
        const Sample result[4] = {0, roughness, 0, one};
        std::memcpy(&image.pixels[at], result, sizeof result);
    }
}

Image roughnessImage(Image image, float factor) {
    if (image.sampleSize == SampleSize::bits8) {
        glossinessToRoughness<std::uint8_t>(image, factor);
    } else {
        glossinessToRoughness<std::uint16_t>(image, factor);
    }
    return image;
}

class ImageJobs {
  public:
    ImageJobs(const Document& document, Storage& storage, const Host& host)
        : document_(document), storage_(storage), host_(host) {}

    /// The place of the job; none where the file cannot be read, which is noted.
    std::optional<std::size_t> addPlain(std::size_t image) {
        return add(
            image, [](Image decoded) { return decoded; }, "");
    }
    std::optional<std::size_t> addRoughness(std::size_t image, float factor) {
        const auto convert = [factor](Image decoded) { return roughnessImage(std::move(decoded), factor); };
        return add(image, convert, " (roughness)");
    }

    const std::vector<ImageJob>& jobs() const { return jobs_; }

  private:
    template <typename Convert>
    std::optional<std::size_t> add(std::size_t image, const Convert& convert, const char* suffix) {
        const Source& source = document_.imageSources[image];
        const std::string element = elementName("image", image, source.name);
        const bool isLeftOut = host_.leavesOut([&] {
            const Bytes file = imageFile(document_, image, element, storage_, host_);
            jobs_.push_back({imageName(source) + suffix, decodedSize(file),
                             [=] { return convert(decodeImage(file, element)); }});
        });
        if (isLeftOut) return std::nullopt;
        return jobs_.size() - 1;
    }

    const Document& document_;
    Storage& storage_;
    const Host& host_;
    std::vector<ImageJob> jobs_;
};

}  // namespace

Bytes imageFile(const Document& document, std::size_t index, const std::string& element, Storage& storage,
                const Host& host) {
    const Source& source = document.imageSources.at(index);
    requireUsable(document, elementName("image", index, source.name));
    if (source.uri) return loadUri(*source.uri, element, storage, host);
    if (source.bufferView) return viewBytes(document, *source.bufferView, element);
    throw Failure{element, "neither a URI nor a bufferView"};
}

AddedImages addImages(const Document& document, Storage& storage, const Host& host, double from, double to) {
    const ImagesInUse used = imagesInUse(document);
    ImageJobs jobs(document, storage, host);
    std::vector<std::optional<std::size_t>> plain(used.plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
        if (used.plain[i]) plain[i] = jobs.addPlain(i);
    }
    std::vector<std::optional<std::size_t>> roughness;
    for (const auto& [image, factor] : used.roughness)
        roughness.push_back(plain[image] ? jobs.addRoughness(image, factor) : std::nullopt);

    const std::vector<std::int32_t> added = candela_plugins::addImages(jobs.jobs(), host, from, to);
    const auto indexOf = [&](const std::optional<std::size_t>& job) { return job ? added[*job] : -1; };
    AddedImages images;
    for (const std::optional<std::size_t>& job : plain) images.indices.push_back(indexOf(job));
    std::size_t next = 0;
    for (const auto& key : used.roughness) images.roughness.emplace(key, indexOf(roughness[next++]));
    return images;
}

}  // namespace candela_plugins::gltf
