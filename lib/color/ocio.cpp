#include "color/ocio.h"

#include <cctype>

namespace candela {

namespace {

using Filter = LookupTexture::Filter;

Filter filterFor(OCIO::Interpolation interpolation) {
    // For tetrahedra the shader fetches the corners themselves.
    const bool isNearest = interpolation == OCIO::INTERP_NEAREST || interpolation == OCIO::INTERP_TETRAHEDRAL;
    return isNearest ? Filter::nearest : Filter::linear;
}

/// A one-dimensional table; OpenColorIO folds long ones into rows.
LookupTexture table1D(const OCIO::GpuShaderDesc& description, unsigned index) {
    const char *texture = nullptr, *sampler = nullptr;
    unsigned width = 0, height = 0;
    OCIO::GpuShaderDesc::TextureType channel{};
    OCIO::Interpolation interpolation{};
    description.getTexture(index, texture, sampler, width, height, channel, interpolation);
    const float* values = nullptr;
    description.getTextureValues(index, values);
    const int channels = channel == OCIO::GpuShaderDesc::TEXTURE_RED_CHANNEL ? 1 : 3;
    const std::size_t count = std::size_t(width) * height * channels;
    return {sampler,
            height > 1 ? 2 : 1,
            int(width),
            int(height),
            1,
            channels,
            filterFor(interpolation),
            {values, values + count}};
}

LookupTexture table3D(const OCIO::GpuShaderDesc& description, unsigned index) {
    const char *texture = nullptr, *sampler = nullptr;
    unsigned edge = 0;
    OCIO::Interpolation interpolation{};
    description.get3DTexture(index, texture, sampler, edge, interpolation);
    const float* values = nullptr;
    description.get3DTextureValues(index, values);
    const std::size_t count = std::size_t(edge) * edge * edge * 3;
    return {
        sampler, 3, int(edge), int(edge), int(edge), 3, filterFor(interpolation), {values, values + count}};
}

}  // namespace

std::string oneLine(const std::string& message) {
    std::string line;
    for (const char c : message) {
        const bool isSpace = std::isspace(static_cast<unsigned char>(c)) != 0;
        if (!isSpace)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    if (!line.empty() && line.back() == ' ') line.pop_back();
    return line;
}

std::string exactGlsl(const OCIO::ConstProcessorRcPtr& part, const std::string& name,
                      std::vector<LookupTexture>& textures) {
    OCIO::GpuShaderDescRcPtr description = OCIO::GpuShaderDesc::CreateShaderDesc();
    description->setLanguage(OCIO::GPU_LANGUAGE_GLSL_4_0);
    description->setFunctionName(name.c_str());
    description->setResourcePrefix(name.c_str());
    part->getOptimizedGPUProcessor(ocioPrecision)->extractGpuShaderInfo(description);
    if (description->getNumUniforms() > 0)
        throw OCIO::Exception(
            "it has values that change from outside (dynamic properties); none were expected");
    for (unsigned i = 0; i < description->getNumTextures(); ++i) textures.push_back(table1D(*description, i));
    for (unsigned i = 0; i < description->getNum3DTextures(); ++i)
        textures.push_back(table3D(*description, i));
    return description->getShaderText();
}

}  // namespace candela
