#include "color/display_encoding.h"

#include "base/primaries.h"

#include <array>
#include <cmath>
#include <vector>

namespace candela {

namespace {

using Transfer = DisplayEncoding::Transfer;

const DisplayEncoding unknownEncoding{Transfer::unknown, 0.0, std::nullopt};

const std::vector<DisplayEncoding>& taggableEncodings() {
    static const std::vector<DisplayEncoding> encodings{
        {Transfer::srgb, 2.2, rec709Primaries()},  {Transfer::gamma, 2.4, rec709Primaries()},
        {Transfer::gamma, 2.2, rec709Primaries()}, {Transfer::srgb, 2.2, p3D65Primaries()},
        {Transfer::gamma, 2.6, p3D65Primaries()},
    };
    return encodings;
}

double codeValue(const DisplayEncoding& encoding, double light) {
    if (encoding.transfer == Transfer::gamma) return std::pow(light, 1.0 / encoding.gamma);
    // IEC 61966-2-1.
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

bool hasEncoding(const OCIO::CPUProcessor& fromXyz, const DisplayEncoding& encoding) {
    constexpr std::array lights{
        glm::dvec3(0.0),           glm::dvec3(0.002),         glm::dvec3(0.02),
        glm::dvec3(0.18),          glm::dvec3(0.5),           glm::dvec3(1.0),
        glm::dvec3(1.0, 0.1, 0.1), glm::dvec3(0.1, 1.0, 0.1), glm::dvec3(0.1, 0.1, 1.0)};
    // A quarter of an 8-bit code: configs round matrices to six digits or so, and no two of the encodings
    // come that close.
    constexpr double tolerance = 1e-3;
    const glm::dmat3 xyz = xyzFromRgb(*encoding.chromaticities);
    for (const glm::dvec3& light : lights) {
        const glm::dvec3 color = xyz * light;
        std::array<float, 3> code{float(color.x), float(color.y), float(color.z)};
        fromXyz.applyRGB(code.data());
        for (int i = 0; i < 3; ++i)
            if (!(std::abs(code[i] - codeValue(encoding, light[i])) <= tolerance)) return false;
    }
    return true;
}

OCIO::ConstColorSpaceRcPtr displayColorSpace(const OCIO::ConstConfigRcPtr& config, const std::string& display,
                                             const std::string& view) {
    const std::string name = config->getDisplayViewColorSpaceName(display.c_str(), view.c_str());
    const bool isDisplaysOwn = name == OCIO::OCIO_VIEW_USE_DISPLAY_NAME;
    const auto space = config->getColorSpace(isDisplaysOwn ? display.c_str() : name.c_str());
    const bool isForDisplay = space && space->getReferenceSpaceType() == OCIO::REFERENCE_SPACE_DISPLAY;
    return isForDisplay && !space->isData() ? space : nullptr;
}

}  // namespace

DisplayEncoding findDisplayEncoding(const OCIO::ConstConfigRcPtr& config, const std::string& display,
                                    const std::string& view) {
    const auto space = displayColorSpace(config, display, view);
    const auto xyz = config->getColorSpace(OCIO::ROLE_INTERCHANGE_DISPLAY);
    if (!space || !xyz) return unknownEncoding;
    const auto processor =
        config->getProcessor(xyz->getName(), space->getName())->getOptimizedCPUProcessor(ocioPrecision);
    for (const DisplayEncoding& encoding : taggableEncodings())
        if (hasEncoding(*processor, encoding)) return encoding;
    return unknownEncoding;
}

}  // namespace candela
