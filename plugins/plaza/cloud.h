#pragma once

#include <candela/plugin.h>

#include <string>

namespace plaza {

/// "cloud:N": N lights of 0.3 m range, evenly over a sphere of 50 m around the camera, and a shell just
/// outside it that they light. A `Generator`. Another N moves every light.
void makeCloud(const candela_host& host, const std::string& arguments);

}  // namespace plaza
