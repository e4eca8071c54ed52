#pragma once

#include <candela/plugin.h>

#include <string>

namespace plaza {

/// "sculpture:N": the plaza with a subdivision cage before the camera, a ring of square section that turns by
/// three half turns on its way round. Two of its four edges are infinitely sharp, the other two are smooth. A
/// `Generator`.
void makeSculpture(const candela_host& host, const std::string& arguments);

}  // namespace plaza
