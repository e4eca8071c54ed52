#pragma once

#include <candela/image_file.h>

#include "color/ocio.h"

#include <string>

namespace candela {

/// How a view of a display encodes its code values. Measured, not read from names: the view's display colour
/// space is fed with colours of known XYZ, and its answers are compared with the encodings that can be
/// tagged. `unknown` where the config gives no such space, or the answers fit none.
DisplayEncoding findDisplayEncoding(const OCIO::ConstConfigRcPtr& config, const std::string& display,
                                    const std::string& view);

}  // namespace candela
