#include "color/working_space.h"

#include <candela/error.h>

#include "base/primaries.h"

#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace candela {

namespace {

/// A space of the config with a known definition, and the conversion into it from linear Rec.709.
struct Anchor {
    std::string space;
    glm::dmat3 fromRec709;
    bool mayBeNonlinear;  ///< The conversion on to the working space may contain a tone curve.
};

/// Names that published configs give to linear Rec.709: those of OpenColorIO's and ACES's own configs, and
/// Blender's.
constexpr std::array linearRec709Names{"Linear Rec.709 (sRGB)",
                                       "lin_rec709_scene",
                                       "lin_rec709_srgb",
                                       "lin_rec709",
                                       "lin_srgb",
                                       "Utility - Linear - Rec.709",
                                       "Linear Rec.709",
                                       "Utility - Linear - sRGB",
                                       "Linear sRGB",
                                       "Linear BT.709"};

std::optional<std::string> spaceNamed(const OCIO::ConstConfigRcPtr& config, const char* nameOrRole) {
    const OCIO::ConstColorSpaceRcPtr space = config->getColorSpace(nameOrRole);
    if (!space || space->isData()) return std::nullopt;
    return space->getName();
}

std::vector<Anchor> findAnchors(const OCIO::ConstConfigRcPtr& config) {
    std::vector<Anchor> anchors;
    if (const auto space = spaceNamed(config, OCIO::ROLE_INTERCHANGE_SCENE))
        anchors.push_back({*space, rgbFromRgb(ap0Primaries(), rec709Primaries()), false});
    // From the display reference space OpenColorIO inverts the default view transform, which may have a tone
    // curve.
    if (const auto space = spaceNamed(config, OCIO::ROLE_INTERCHANGE_DISPLAY))
        anchors.push_back({*space, xyzFromRgb(rec709Primaries()), true});
    for (const char* name : linearRec709Names)
        if (const auto space = spaceNamed(config, name)) anchors.push_back({*space, glm::dmat3(1.0), false});
    return anchors;
}

/// A conversion between two spaces, one colour at a time.
class Probe {
  public:
    Probe(const OCIO::ConstConfigRcPtr& config, const std::string& from, const std::string& to)
        : processor_(
              config->getProcessor(from.c_str(), to.c_str())->getOptimizedCPUProcessor(ocioPrecision)) {}

    glm::dvec3 operator()(const glm::dvec3& color) const {
        std::array<float, 3> rgb{float(color.x), float(color.y), float(color.z)};
        processor_->applyRGB(rgb.data());
        return {rgb[0], rgb[1], rgb[2]};
    }

  private:
    OCIO::ConstCPUProcessorRcPtr processor_;
};

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The conversion as a 3×3 matrix; none when it is not linear.
std::optional<glm::dmat3> linearMap(const Probe& probe) {
    const glm::dmat3 matrix{probe({1.0, 0.0, 0.0}), probe({0.0, 1.0, 0.0}), probe({0.0, 0.0, 1.0})};
    // Dim, mid and bright colours: a curve shows at some level, and an offset at black.
    constexpr std::array samples{glm::dvec3(0.0), glm::dvec3(0.18), glm::dvec3(0.01, 0.002, 0.03),
                                 glm::dvec3(0.9, 0.2, 0.5), glm::dvec3(8.0, 6.0, 3.0)};
    // A space defined by look-up tables, for example of half floats, is linear to about three digits.
    constexpr double relative = 2e-3, absolute = 1e-5;
    for (const glm::dvec3& sample : samples) {
        const double error = largest(probe(sample) - matrix * sample);
        if (!(error <= absolute + relative * largest(sample))) return std::nullopt;
    }
    if (!(std::abs(glm::determinant(matrix)) > 1e-6)) return std::nullopt;
    return matrix;
}

double difference(const glm::dmat3& a, const glm::dmat3& b) {
    return std::max({largest(a[0] - b[0]), largest(a[1] - b[1]), largest(a[2] - b[2])});
}

/// The primaries of the space that `fromRec709` leads into. A matrix does not show to which white it adapted,
/// so well-known spaces are identified by their matrix, and others are described relative to Rec.709's white.
Chromaticities primariesOf(const glm::dmat3& fromRec709) {
    // Wide enough for another adaptation than Bradford's (CAT02 moves AP1's matrix by 0.002), far closer than
    // any two of the spaces are to each other.
    constexpr double tolerance = 4e-3;
    for (const KnownPrimaries& space : knownPrimaries())
        if (difference(fromRec709, rgbFromRgb(space.chromaticities, rec709Primaries())) < tolerance)
            return space.chromaticities;
    const glm::dmat3 toXyz = xyzFromRgb(rec709Primaries()) * glm::inverse(fromRec709);
    return {chromaticity(toXyz[0]), chromaticity(toXyz[1]), chromaticity(toXyz[2]),
            chromaticity(toXyz * glm::dvec3(1.0))};
}

OCIO::ConstColorSpaceRcPtr sceneLinearSpace(const OCIO::ConstConfigRcPtr& config, const std::string& source) {
    if (const auto space = config->getColorSpace(OCIO::ROLE_SCENE_LINEAR)) return space;
    std::string roles;
    for (int i = 0; i < config->getNumRoles(); ++i)
        roles += (roles.empty() ? "" : ", ") + std::string(config->getRoleName(i));
    throw Error(
        ErrorKind::badInput, source,
        "no colour space has the role scene_linear, which candela shades in; the config has the roles: " +
            (roles.empty() ? "none" : roles));
}

}  // namespace

WorkingSpace findWorkingSpace(const OCIO::ConstConfigRcPtr& config, const std::string& source) {
    const OCIO::ConstColorSpaceRcPtr space = sceneLinearSpace(config, source);
    WorkingSpace working;
    working.name = space->getName();
    const std::vector<Anchor> anchors = space->isData() ? std::vector<Anchor>{} : findAnchors(config);
    for (const Anchor& anchor : anchors) {
        const auto matrix = linearMap(Probe(config, anchor.space, working.name));
        if (!matrix && anchor.mayBeNonlinear) continue;
        if (!matrix)
            throw Error(ErrorKind::badInput, source,
                        "the role scene_linear names the colour space '" + working.name +
                            "', which is not linear in light: the conversion into it from '" + anchor.space +
                            "' is not an invertible matrix");
        working.fromRec709 = *matrix * anchor.fromRec709;
        // Rounding in the probe's single precision must not tint a scene that needs no conversion.
        if (difference(working.fromRec709, glm::dmat3(1.0)) < 1e-5) working.fromRec709 = glm::dmat3(1.0);
        working.chromaticities = primariesOf(working.fromRec709);
        return working;
    }
    working.notes.push_back(
        "the config does not say what the primaries of its working space '" + working.name +
        "' are (it has no role aces_interchange and no colour space of a well-known name); "
        "they are taken to be those of Rec.709");
    return working;
}

}  // namespace candela
