#pragma once

#include <candela/image_file.h>

#include "color/ocio.h"

#include <glm/mat3x3.hpp>

#include <string>
#include <vector>

namespace candela {

/// The space that shading works in.
struct WorkingSpace {
    std::string name;
    glm::dmat3 fromRec709{1.0};
    Chromaticities chromaticities;
    std::vector<std::string> notes;  ///< Assumptions, one line each.
};

/// Finds the space of the role scene_linear and how it relates to linear Rec.709. `source` names the config
/// in messages. Throws `Error` (badInput) when there is no such role or the space is not linear in light.
WorkingSpace findWorkingSpace(const OCIO::ConstConfigRcPtr& config, const std::string& source);

}  // namespace candela
