// The shaders: each stage compiles alone, each program links, and C++ and GLSL agree on shared layouts.

#include "gl/program.h"
#include "gl/shader_source.h"
#include "render/debug/debug_view_pass.h"
#include "render/layout.h"

#include <candela/context.h>
#include <candela/error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace candela::test {
namespace {

using Definitions = std::vector<std::string>;

bool isStage(std::string_view name) {
    return name.ends_with(".vert") || name.ends_with(".geom") || name.ends_with(".frag") ||
           name.ends_with(".comp");
}

/// What lib/render may define for a stage, whether or not the stage reads it.
std::vector<Definitions> combinations() {
    std::vector<Definitions> all;
    for (const char* model : {"BRDF BRDF_COURSE", "BRDF BRDF_GLTF"}) {
        for (const char* kind : {"SPOT 0", "SPOT 1"})
            all.push_back({model, kind, "SOURCE 0", "VIEW_CODE vec3(depth)", "HEAT_STOPS 5", "TEXTURED 0",
                           "CORNERS 2", "WIDE_CORNERS 2", "FILL 0", "LOAD_RADIANCE 0", "DEPTH 1",
                           "RADIANCE 1", "USE 1"});
    }
    for (const char* kind : {"SPOT 0", "SPOT 1"})
        all.push_back({"BRDF BRDF_GLTF", kind, "SHADOWS 1", "VISIBILITY 1", "MOTION 1", "SOURCE 0",
                       "VIEW_CODE vec3(depth)", "HEAT_STOPS 5", "TEXTURED 0", "CORNERS 2", "WIDE_CORNERS 2",
                       "FILL 0", "LOAD_RADIANCE 0", "DEPTH 1", "RADIANCE 1", "USE 2"});
    all.push_back({"BRDF BRDF_GLTF", "SPOT 0", "LAYER 1", "SOURCE 0", "VIEW_CODE vec3(depth)", "HEAT_STOPS 5",
                   "TEXTURED 1", "CORNERS 2", "WIDE_CORNERS 2", "FILL 0", "LOAD_RADIANCE 0", "DEPTH 1",
                   "RADIANCE 1", "USE 0"});
    all.push_back({"BRDF BRDF_GLTF", "SPOT 0", "LAYER 1", "LOBES 1", "EXTENDED 1", "REFRACTION 1",
                   "BLURRED 1", "DISPERSED 1", "SOURCE 0", "VIEW_CODE vec3(depth)", "HEAT_STOPS 5",
                   "TEXTURED 1", "CORNERS 2", "WIDE_CORNERS 2", "FILL 0", "LOAD_RADIANCE 0", "DEPTH 1",
                   "RADIANCE 1", "USE 0"});
    all.push_back({"BRDF BRDF_GLTF", "SPOT 0", "LAYER 1", "LOBES 1", "EXTENDED 1", "REFRACTION 1",
                   "FURTHER_UVS 8", "MOTION 1", "SOURCE 0", "VIEW_CODE vec3(depth)", "HEAT_STOPS 5",
                   "TEXTURED 1", "CORNERS 2", "WIDE_CORNERS 2", "FILL 0", "LOAD_RADIANCE 0", "DEPTH 1",
                   "RADIANCE 1", "USE 0"});
    for (const DebugView debugView : debugViews()) {
        Definitions definitions = debugViewDefinitions(debugViewRow(debugView));
        definitions.insert(definitions.end(),
                           {"BRDF BRDF_COURSE", "SPOT 0", "TEXTURED 1", "CORNERS 3", "WIDE_CORNERS 1",
                            "FILL 1", "LOAD_RADIANCE 1", "DEPTH 0", "RADIANCE 1", "USE 0"});
        all.push_back(definitions);
    }
    return all;
}

/// The stages of a program that lib/render links.
struct Linked {
    std::string vertex, fragment;
    std::string appended{};
    std::string geometry{};
};

const std::vector<Linked> table{
    {"surface_plain.vert", "surface_plain.frag"},
    {"surface_textured.vert", "surface_textured.frag"},
    {"fullscreen_triangle.vert", "fullscreen.frag"},
    {"fullscreen_triangle.vert", "depth_copy.frag"},
    {"fullscreen_triangle.vert", "environment.frag"},
    {"fullscreen_triangle.vert", "background.frag"},
    {"light_volume.vert", "light_volume.frag"},
    {"light_volume.vert", "light_volume_mark.frag"},
    {"light_volume.vert", "light_volume_count.frag"},
    {"fullscreen_triangle.vert", "display.frag",
     "vec4 displayTransform(vec4 radiance) { return radiance; }\n"},
    {"fullscreen_triangle.vert", "debug_view.frag"},
    {"fullscreen_triangle.vert", "debug_view_display.frag"},
    {"fullscreen_triangle.vert", "overlay_display.frag"},
    {"fullscreen_triangle.vert", "layer_composite.frag"},
    {"fullscreen_triangle.vert", "layer_store.frag"},
    {"fullscreen_triangle.vert", "layer_depth.frag"},
    {"fullscreen_triangle.vert", "layer_ties.frag"},
    {"layer_fragment.vert", "layer_fragment.frag"},
    {"layer_fragment.vert", "layer_fragment.frag", {}, "layer_fragment.geom"},
    {"fullscreen_triangle.vert", "sample_add.frag"},
    {"fullscreen_triangle.vert", "sample_mean.frag"},
    {"overlay_mesh.vert", "overlay_lines.frag", {}, "overlay_edges.geom"},
    {"overlay_cage.vert", "overlay_lines.frag", {}, "overlay_edges.geom"},
    {"surface_instance.vert", "surface_instance.frag"},
    {"fullscreen_triangle.vert", "depth_conversion.frag"},
    {"surface_plain.vert", "surface_plain.frag", {}, "surface_plain.geom"},
    {"surface_textured.vert", "surface_textured.frag", {}, "surface_textured.geom"},
    {"surface_instance.vert", "surface_instance.frag", {}, "surface_instance.geom"},
};

GLenum kindOf(std::string_view name) {
    return name.ends_with(".vert")   ? GL_VERTEX_SHADER
           : name.ends_with(".geom") ? GL_GEOMETRY_SHADER
           : name.ends_with(".frag") ? GL_FRAGMENT_SHADER
                                     : GL_COMPUTE_SHADER;
}

/// The compiler's message; empty when the shader compiles.
std::string compilerMessage(GLenum kind, const std::string& text) {
    const GLuint shader = glCreateShader(kind);
    const char* texts[] = {text.c_str()};
    glShaderSource(shader, 1, texts, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    std::string message(2000, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, GLsizei(message.size()), &length, message.data());
    message.resize(static_cast<std::size_t>(length));
    glDeleteShader(shader);
    return compiled == GL_TRUE ? "" : "not compiled: " + message;
}

/// Sets CANDELA_SHADER_DIR to a folder with a copy of the shaders.
class ShaderFolder {
  public:
    ShaderFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "candela-shaders-XXXXXX").string();
        path_ = mkdtemp(name.data());
        for (const gl::EmbeddedShader& shader : gl::embeddedShaders())
            write(std::string(shader.name), shader.text);
        setenv("CANDELA_SHADER_DIR", path_.c_str(), 1);
    }
    ShaderFolder(const ShaderFolder&) = delete;
    ShaderFolder& operator=(const ShaderFolder&) = delete;
    ~ShaderFolder() {
        unsetenv("CANDELA_SHADER_DIR");
        std::filesystem::remove_all(path_);
    }

    void write(const std::string& name, std::string_view text) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name) << text;
    }
    void remove(const std::string& name) const { std::filesystem::remove(path_ / name); }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

class ProgramTest : public testing::Test {
  protected:
    static std::string errorOf(const std::string& vertex, const std::string& fragment) {
        try {
            gl::Program({{vertex, {}, {}}, {fragment, {}, {}}}, "test");
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::environment);
            return error.what();
        }
        return {};
    }

    Context context_ = Context::createHeadless();
};

TEST_F(ProgramTest, everyStageCompilesAlone) {
    int stages = 0;
    for (const gl::EmbeddedShader& shader : gl::embeddedShaders()) {
        if (!isStage(shader.name)) continue;
        ++stages;
        for (const Definitions& definitions : combinations()) {
            const std::string name(shader.name);
            EXPECT_EQ(compilerMessage(kindOf(name), gl::assembleShader(name, definitions)), "")
                << name << " with " << testing::PrintToString(definitions);
        }
    }
    EXPECT_GE(stages, 12);
}

/// The text that the table's programs append to a stage's file.
std::string appendedTo(std::string_view stage) {
    const auto found = std::ranges::find(table, stage, &Linked::fragment);
    return found == table.end() ? "" : found->appended;
}

// A second compiler, which keeps to the GLSL specification where drivers are lenient.
TEST(Shaders, everyStageIsValidForGlslang) {
    if (std::system("glslangValidator --version > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "glslangValidator is not installed; install glslang-tools";
    const ShaderFolder folder;
    std::string command = "cd '" + folder.path().string() + "' && glslangValidator";
    int count = 0;
    for (const gl::EmbeddedShader& shader : gl::embeddedShaders()) {
        if (!isStage(shader.name)) continue;
        const std::string name(shader.name);
        for (const Definitions& definitions : combinations()) {
            const std::string file = "variant" + std::to_string(count++) + "_" + name;
            folder.write(file, gl::assembleShader(name, definitions) + appendedTo(name));
            command += " " + file;
        }
    }
    EXPECT_GT(count, 100);
    const std::string log = (folder.path() / "glslang.log").string();
    const int status = std::system((command + " > " + log + " 2>&1").c_str());
    std::ostringstream message;
    message << std::ifstream(log).rdbuf();
    EXPECT_EQ(status, 0) << message.str();
}

TEST_F(ProgramTest, everyStageIsInTheProgramTable) {
    for (const gl::EmbeddedShader& shader : gl::embeddedShaders()) {
        if (!isStage(shader.name) || shader.name.ends_with(".comp")) continue;
        const bool known = std::ranges::any_of(table, [&](const Linked& linked) {
            return linked.vertex == shader.name || linked.fragment == shader.name ||
                   linked.geometry == shader.name;
        });
        EXPECT_TRUE(known) << shader.name << ": a new stage has to be added to this test's table";
    }
}

TEST_F(ProgramTest, everyProgramLinksWithoutAnError) {
    for (const Linked& linked : table) {
        for (const Definitions& definitions : combinations()) {
            std::vector<gl::Stage> stages{{linked.vertex, definitions, {}},
                                          {linked.fragment, definitions, linked.appended}};
            if (!linked.geometry.empty()) stages.push_back({linked.geometry, definitions, {}});
            const gl::Program program(stages, "test");
            EXPECT_NE(program.name(), 0u);
        }
    }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST_F(ProgramTest, compilerMessageIsSetForABrokenShader) {
    EXPECT_NE(compilerMessage(GL_VERTEX_SHADER, "#version 450 core\nvoid main() { gl_Position = 1; }\n"), "");
}

GLint memberOffset(GLuint program, const std::string& member) {
    const GLuint index = glGetProgramResourceIndex(program, GL_UNIFORM, ("frame." + member).c_str());
    if (index == GL_INVALID_INDEX) return -1;
    constexpr GLenum property = GL_OFFSET;
    GLint offset = -1;
    glGetProgramResourceiv(program, GL_UNIFORM, index, 1, &property, 1, nullptr, &offset);
    return offset;
}

GLint blockSize(GLuint program) {
    const GLuint block = glGetProgramResourceIndex(program, GL_UNIFORM_BLOCK, "FrameBlock");
    if (block == GL_INVALID_INDEX) return -1;
    constexpr GLenum property = GL_BUFFER_DATA_SIZE;
    GLint size = -1;
    glGetProgramResourceiv(program, GL_UNIFORM_BLOCK, block, 1, &property, 1, nullptr, &size);
    return size;
}

TEST_F(ProgramTest, frameUniformOffsetsMatchCpp) {
    using Frame = layout::FrameUniforms;
    const std::vector<std::pair<std::string, std::size_t>> members{
        {"clipFromWorld", offsetof(Frame, clipFromWorld)},
        {"eye", offsetof(Frame, eye)},
        {"rayCorner", offsetof(Frame, rayCorner)},
        {"rayStepX", offsetof(Frame, rayStepX)},
        {"rayStepY", offsetof(Frame, rayStepY)},
        {"workingFromRed", offsetof(Frame, workingFromRed)},
        {"workingFromGreen", offsetof(Frame, workingFromGreen)},
        {"workingFromBlue", offsetof(Frame, workingFromBlue)},
        {"size", offsetof(Frame, size)},
        {"lightCounts", offsetof(Frame, lightCounts)},
    };
    int programs = 0;
    for (const Linked& linked : table) {
        const gl::Program program(
            {{linked.vertex, combinations()[0], {}}, {linked.fragment, combinations()[0], linked.appended}},
            "test");
        if (blockSize(program.name()) < 0) continue;
        ++programs;
        EXPECT_EQ(blockSize(program.name()), GLint(sizeof(Frame))) << linked.fragment;
        for (const auto& [member, offset] : members)
            EXPECT_EQ(memberOffset(program.name(), member), GLint(offset))
                << linked.fragment << ", " << member;
    }
    EXPECT_GE(programs, 5);
}

TEST_F(ProgramTest, folderOfTheEnvironmentReplacesEmbeddedShaders) {
    const ShaderFolder folder;
    EXPECT_EQ(errorOf("fullscreen_triangle.vert", "depth_copy.frag"), "");
    folder.write("lib/frame.glsl", "const int onlyInThisFolder = 1;\n");
    EXPECT_NE(gl::assembleShader("surface_plain.vert").find("onlyInThisFolder"), std::string::npos);
}

TEST_F(ProgramTest, brokenShaderIsAnErrorWithItsNameAndTheCompilersMessage) {
    const ShaderFolder folder;
    folder.write("depth_copy.frag", "void main() { gl_FragDepth = notDeclaredAnywhere; }\n");
    const std::string text = errorOf("fullscreen_triangle.vert", "depth_copy.frag");
    EXPECT_NE(text.find("depth_copy.frag"), std::string::npos) << text;
    EXPECT_NE(text.find("notDeclaredAnywhere"), std::string::npos) << text;
}

TEST_F(ProgramTest, failedLinkIsAnErrorWithTheLinkersMessage) {
    const ShaderFolder folder;
    folder.write("depth_copy.frag", "void missing();\nvoid main() { missing(); }\n");
    const std::string text = errorOf("fullscreen_triangle.vert", "depth_copy.frag");
    EXPECT_NE(text.find("depth_copy.frag"), std::string::npos) << text;
    EXPECT_NE(text.find("missing"), std::string::npos) << text;
}

TEST_F(ProgramTest, shaderThatIsMissingIsAnErrorWithItsPath) {
    const ShaderFolder folder;
    folder.remove("lib/frame.glsl");
    const std::string text = errorOf("surface_plain.vert", "surface_plain.frag");
    EXPECT_NE(text.find((folder.path() / "lib/frame.glsl").string()), std::string::npos) << text;
    EXPECT_NE(text.find("CANDELA_SHADER_DIR"), std::string::npos) << text;
}

TEST_F(ProgramTest, includesAreInsertedOnceAndDefinitionsComeFirst) {
    const ShaderFolder folder;
    folder.write("a.glsl", "#include \"b.glsl\"\nA\n");
    folder.write("b.glsl", "#include \"a.glsl\"\nB\n");
    folder.write("main.vert", "#include \"a.glsl\"\n#include \"b.glsl\"\nMAIN\n");
    EXPECT_EQ(gl::assembleShader("main.vert", {"ONE 1", "TWO 2"}),
              "#version 450 core\n#define ONE 1\n#define TWO 2\nB\nA\nMAIN\n");
}

}  // namespace
}  // namespace candela::test
