#pragma once

#include <candela/camera.h>
#include <candela/image_file.h>

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

/// What the header of an EXR says of its picture.
struct ExrMetadata {
    candela::CameraView view;  ///< Of the middle of the shutter interval.
    glm::dvec3 origin{0.0};    ///< `candela::Scene::origin`: the matrices are of the file's space.
    /// Width over height; none of a panorama, which no projection onto a plane shows.
    std::optional<float> aspect = 1.0f;
    int frame = 0;
    double framesPerSecond = 24.0;
    std::string camera;
    std::string workingSpace;  ///< Its name in the OpenColorIO config.
    candela::Chromaticities chromaticities;
};

/// The standard attributes worldToCamera, worldToNDC, screenWindowWidth, framesPerSecond, imageCounter and
/// cameraLabel; software, workingSpace and, of spaces that have one, colorInteropID. A panorama has no
/// worldToNDC and no screenWindowWidth.
///
/// Camera space is left-handed with +Z forward and NDC is 0 to 1 from the upper left corner, as of RenderMan.
/// Source: OpenEXR, ImfStandardAttributes.h.
std::vector<candela::ExrAttribute> exrMetadata(const ExrMetadata& metadata);

/// The fraction of the smallest denominator that is the number in double precision, or the nearest one whose
/// parts fit.
candela::ExrRational toRational(double number);
