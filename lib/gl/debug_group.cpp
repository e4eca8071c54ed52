#include "gl/debug_group.h"

#include <epoxy/gl.h>

namespace candela::gl {

DebugGroup::DebugGroup(const char* name) {
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
}

DebugGroup::~DebugGroup() {
    glPopDebugGroup();
}

}  // namespace candela::gl
