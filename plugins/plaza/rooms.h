#pragma once

#include <candela/plugin.h>

#include <string>

namespace plaza {

/// "rooms:N": 16 × 16 furnished rooms with doorways on 100 m × 100 m, N lights spread over them, and a camera
/// in one of the rooms. A `Generator`.
void makeRooms(const candela_host& host, const std::string& arguments);

}  // namespace plaza
