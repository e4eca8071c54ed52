#pragma once

#include <candela/image_file.h>

#include "color/ocio.h"

#include <string>

namespace candela {

/// How a view of a display encodes its code values. Measured, not derived from names: colours of known XYZ
/// are converted to the view's display colour space, and the results are compared with the encodings that can
/// be tagged. `unknown` where the config has no such space, or no encoding matches.
DisplayEncoding findDisplayEncoding(const OCIO::ConstConfigRcPtr& config, const std::string& display,
                                    const std::string& view);

}  // namespace candela
