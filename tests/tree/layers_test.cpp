#include "layers.h"

#include "generated_tree.h"
#include "source_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace candela {
namespace {

const std::filesystem::path sourceTree = CANDELA_SOURCE_TREE;

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

TEST(Layers, OfThisTreeHold) {
    EXPECT_EQ(joined(layerViolations(sourceTree)), "");
    // Guards against a check of wrong folders.
    for (const char* folder : {"include/candela", "lib/base", "lib/scene", "lib/import", "lib/color",
                               "lib/gl", "lib/render", "plugins/gltf", "plugins/plaza", "apps/render"}) {
        EXPECT_FALSE(filesBelow(sourceTree / folder, {".h", ".cpp"}).empty()) << folder;
    }
}

TEST(Layers, UmbrellaHeaderIncludesTheRest) {
    EXPECT_EQ(joined(missingInUmbrella(sourceTree)), "");
}

using LayersOfGeneratedTree = GeneratedTree;

TEST_F(LayersOfGeneratedTree, AllowedDependenciesPass) {
    write("include/candela/scene.h",
          "#include <candela/mesh.h>\n#include <glm/mat4x4.hpp>\n#include <vector>\n");
    write("include/candela/plugin.h", "#include <stddef.h>\n#include <stdint.h>\n");
    write("include/candela/candela.h", "#include <candela/renderer.h>\n#include <candela/plugin.h>\n");
    write("lib/base/error.cpp",
          "#include <candela/error.h>\n#include \"base/thread_pool.h\"\n#include <png.h>\n");
    write("lib/import/host.cpp", "#include \"scene/normals.h\"\n#include <candela/plugin.h>\n");
    write("lib/gl/program.cpp", "#include <epoxy/gl.h>\n#include \"base/thread_pool.h\"\n");
    write("lib/render/upload.cpp",
          "#include \"gl/buffer.h\"\n#include <candela/scene.h>\n#include \"shared/frame.h\"\n");
    write("plugins/plaza/plaza.cpp",
          "#include <candela/plugin.h>\n#include \"shapes.h\"\n#include <cmath>\n"
          "#include \"../common/host.h\"\n");
    write("plugins/common/host.h", "#include <candela/plugin.h>\n");
    write("plugins/plaza/shapes.h", "#include <vector>\n");
    write("plugins/plaza/CMakeLists.txt",
          "candela_plugin(plaza plaza.cpp)  # Does not link candela::candela.\n");
    write("apps/render/main.cpp",
          "#include <candela/candela.h>\n#include <candela/plugin.h>\n#include \"list.h\"\n"
          "#include \"../common/args.h\"\n#include \"common/args.h\"\n#include <GLFW/glfw3.h>\n");
    write("apps/render/list.h", "");
    write("apps/common/args.h", "");
    write("python/src/scene.cpp",
          "#include \"scene.h\"\n#include <candela/scene.h>\n#include <nanobind/nanobind.h>\n");
    write("python/src/scene.h", "");
    EXPECT_EQ(joined(layerViolations(root())), "");
}

struct ForbiddenDependency {
    const char *path, *text, *violation;
};

TEST_F(LayersOfGeneratedTree, EachForbiddenDependencyIsFound) {
    const ForbiddenDependency dependencies[] = {
        {"include/candela/mesh.h", "#include <candela/gpu_scene.h>\n",
         "include/candela/mesh.h:1: scene must not include candela/gpu_scene.h of render"},
        {"include/candela/error.h", "\n#include <candela/scene.h>\n",
         "include/candela/error.h:2: base must not include candela/scene.h of scene"},
        {"include/candela/context.h", "#include <candela/scene.h>\n",
         "include/candela/context.h:1: gl must not include candela/scene.h of scene"},
        {"include/candela/context.h", "#include <epoxy/gl.h>\n",
         "include/candela/context.h:1: a public header must not include epoxy/gl.h"},
        {"include/candela/color.h", "  #  include <OpenColorIO/OpenColorIO.h>\n",
         "include/candela/color.h:1: a public header must not include OpenColorIO/OpenColorIO.h"},
        {"include/candela/image_file.h", "#include <png.h>\n",
         "include/candela/image_file.h:1: a public header must not include png.h"},
        {"include/candela/scene.h", "#include \"scene/limits.h\"\n",
         "include/candela/scene.h:1: a public header must not include scene/limits.h"},
        {"include/candela/scene.h", "#include <candela/candela.h>\n",
         "include/candela/scene.h:1: includes candela/candela.h, which has no layer"},
        {"include/candela/plugin.h", "#include <vector>\n",
         "include/candela/plugin.h:1: plugin.h is C, and must not include vector"},
        {"include/candela/plugin.h", "#include <candela/export.h>\n",
         "include/candela/plugin.h:1: abi must not include candela/export.h of base"},
        {"include/candela/unknown.h", "", "include/candela/unknown.h:1: a public header without a layer"},
        {"lib/scene/scene.cpp", "#include \"import/host.h\"\n",
         "lib/scene/scene.cpp:1: scene must not include import/host.h"},
        {"lib/scene/scene.cpp", "#include <epoxy/gl.h>\n",
         "lib/scene/scene.cpp:1: scene must not include epoxy/gl.h"},
        {"lib/import/import.cpp", "#include <GL/gl.h>\n",
         "lib/import/import.cpp:1: import must not include GL/gl.h"},
        {"lib/import/import.cpp", "#include \"color/ocio.h\"\n",
         "lib/import/import.cpp:1: import must not include color/ocio.h"},
        {"lib/color/ocio.cpp", "#include <candela/context.h>\n",
         "lib/color/ocio.cpp:1: color must not include candela/context.h of gl"},
        {"lib/gl/buffer.cpp", "#include <candela/light.h>\n",
         "lib/gl/buffer.cpp:1: gl must not include candela/light.h of scene"},
        {"lib/gl/buffer.cpp", "#include <render/draw_list.h>\n",
         "lib/gl/buffer.cpp:1: gl must not include render/draw_list.h"},
        {"lib/render/draw.cpp", "#include <OpenColorIO/OpenColorIO.h>\n",
         "lib/render/draw.cpp:1: render must not include OpenColorIO/OpenColorIO.h"},
        {"lib/render/gbuffer/geometry_pass.cpp", "#include \"render/renderer_state.h\"\n",
         "lib/render/gbuffer/geometry_pass.cpp:1: a pass must not include render/renderer_state.h"},
        {"lib/scene/brdf.cpp", "#include \"shared/frame.h\"\n",
         "lib/scene/brdf.cpp:1: scene must not include shaders"},
        {"lib/base/error.cpp", "#include \"error.h\"\n",
         "lib/base/error.cpp:1: a private header is included as \"LAYER/name.h\", not error.h"},
        {"lib/base/error.cpp", "#include \"../scene/limits.h\"\n",
         "lib/base/error.cpp:1: a private header is included as \"LAYER/name.h\", not ../scene/limits.h"},
        {"lib/util/text.h", "", "lib/util/text.h:1: a folder that is no layer"},
        {"plugins/gltf/read.cpp", "#include <candela/scene.h>\n",
         "plugins/gltf/read.cpp:1: a plugin must not include candela/scene.h"},
        {"plugins/gltf/read.cpp", "#include \"base/thread_pool.h\"\n",
         "plugins/gltf/read.cpp:1: a plugin must not include base/thread_pool.h"},
        {"plugins/gltf/read.cpp", "#include <scene/limits.h>\n",
         "plugins/gltf/read.cpp:1: a plugin must not include scene/limits.h"},
        {"plugins/gltf/read.cpp", "#include \"../gltf2/other.h\"\n",
         "plugins/gltf/read.cpp:1: a plugin must not include ../gltf2/other.h"},
        {"plugins/gltf/CMakeLists.txt", "target_link_libraries(x PRIVATE candela_scene)\n",
         "plugins/gltf/CMakeLists.txt:1: a plugin must not link candela_scene"},
        {"plugins/gltf/CMakeLists.txt", "target_link_libraries(x PRIVATE candela::candela)\n",
         "plugins/gltf/CMakeLists.txt:1: a plugin must not link candela"},
        {"apps/view/main.cpp", "#include \"scene/limits.h\"\n",
         "apps/view/main.cpp:1: an app must not include scene/limits.h"},
        {"apps/view/main.cpp", "#include <gl/buffer.h>\n",
         "apps/view/main.cpp:1: an app must not include gl/buffer.h"},
        {"python/src/scene.cpp", "#include \"gl/buffer.h\"\n",
         "python/src/scene.cpp:1: the Python package must not include gl/buffer.h"},
        {"apps/view/main.cpp", "#include <candela/unknown.h>\n",
         "apps/view/main.cpp:1: there is no public header candela/unknown.h"},
        {"apps/view/main.cpp", "#include \"../render/list.h\"\n",
         "apps/view/main.cpp:1: an app must not include ../render/list.h"},
    };
    write("plugins/gltf2/other.h", "");
    write("apps/render/list.h", "");
    for (const ForbiddenDependency& one : dependencies) {
        write(one.path, one.text);
        EXPECT_EQ(joined(layerViolations(root())), std::string(one.violation) + "\n");
        std::filesystem::remove(root() / one.path);
    }
    EXPECT_EQ(joined(layerViolations(root())), "");
}

TEST_F(LayersOfGeneratedTree, MissingIncludeOfTheUmbrellaHeaderIsFound) {
    write("include/candela/candela.h", "#include <candela/scene.h>\n");
    const std::vector<std::string> missing = missingInUmbrella(root());
    EXPECT_EQ(std::count(missing.begin(), missing.end(), "renderer.h"), 1);
    EXPECT_EQ(std::count(missing.begin(), missing.end(), "scene.h"), 0);
}

}  // namespace
}  // namespace candela
