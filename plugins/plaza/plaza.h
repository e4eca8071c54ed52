#pragma once

#include <candela/plugin.h>

#include <string>

namespace plaza {

/// "plaza:N": a ground of 100 m with 16 × 16 spheres of all roughnesses under N point lights. A `Generator`.
void makePlaza(const candela_host& host, const std::string& arguments);

}  // namespace plaza
