// A window of GLFW: candela draws first, then the host draws a triangle behind and in front of it, with its
// own classic depth test. Nothing is read back. Run as `embed_glfw [SCENE [FRAMES [PICTURE.png]]]`.

#include <candela/candela.h>

#include <epoxy/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

namespace {

constexpr float nearPlane = 0.1f, farPlane = 200.0f;

/// The host's own program. candela leaves it and all other state alone.
GLuint makeTriangleProgram() {
    const char* vertex =
        "#version 450\nlayout(location = 0) uniform mat4 clip; void main() {"
        "gl_Position = clip * vec4((gl_VertexID - 1) * 4, gl_VertexID == 1 ? 5.0 : 0.0, 0.0, 1.0); }";
    const char* fragment = "#version 450\nout vec4 color; void main() { color = vec4(1.0, 0.0, 1.0, 1.0); }";
    const GLuint program = glCreateProgram();
    for (const GLenum stage : {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER}) {
        const GLuint shader = glCreateShader(stage);
        glShaderSource(shader, 1, stage == GL_VERTEX_SHADER ? &vertex : &fragment, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    return program;
}

void savePicture(const char* path, int width, int height) {
    std::vector<std::uint8_t> rgba(std::size_t{4} * std::size_t(width) * std::size_t(height)), turned;
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    const auto row = std::ptrdiff_t{4} * width;
    for (int y = height; y-- > 0;)
        turned.insert(turned.end(), rgba.begin() + y * row, rgba.begin() + (y + 1) * row);
    candela::writePng(path, std::uint32_t(width), std::uint32_t(height), turned, {});
}

void run(GLFWwindow* window, const char* sceneName, int frames, const char* picture) {
    const candela::Context context = candela::Context::adoptCurrent();
    const candela::Scene scene = candela::importScene(candela::PluginRegistry(), sceneName).scene;
    const candela::ColorConfig color = candela::ColorConfig::builtIn();
    const candela::DisplayTransform display = color.displayTransform({});
    candela::GpuScene gpuScene(context, scene, {.workingFromRec709 = color.workingFromRec709()});
    candela::Renderer renderer(context);
    candela::CameraView view = candela::cameraView(scene, 0, candela::worldTransforms(scene));
    view.nearPlane = nearPlane;

    const GLuint program = makeTriangleProgram();
    GLuint vertexArray = 0;
    glCreateVertexArrays(1, &vertexArray);
    for (int i = 0; frames == 0 || i < frames; ++i) {
        glfwPollEvents();
        if (glfwWindowShouldClose(window)) break;
        int width = 0, height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        if (width < 1 || height < 1) continue;
        const candela::Frame frame = renderer.render(gpuScene, view, {.width = width, .height = height});
        frame.display(display, {});
        frame.writeDepth({}, {.nearPlane = nearPlane, .farPlane = farPlane});

        // The host's part: an ordinary projection, depth test and program.
        const float aspect = float(width) / float(height);
        const glm::mat4 projection = glm::perspective(view.verticalFov, aspect, nearPlane, farPlane);
        const glm::mat4 place = glm::translate(view.worldFromCamera, {0.0f, -3.0f, -14.0f});
        const glm::mat4 clip = projection * glm::inverse(view.worldFromCamera) * place;
        glViewport(0, 0, width, height);
        glEnable(GL_DEPTH_TEST);
        glUseProgram(program);
        glUniformMatrix4fv(0, 1, GL_FALSE, glm::value_ptr(clip));
        glBindVertexArray(vertexArray);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        if (picture != nullptr && i + 1 == frames) savePicture(picture, width, height);
        glfwSwapBuffers(window);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (glfwInit() != GLFW_TRUE) return EXIT_FAILURE;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    GLFWwindow* window = glfwCreateWindow(480, 270, "candela in GLFW", nullptr, nullptr);
    if (window == nullptr) return EXIT_FAILURE;
    glfwMakeContextCurrent(window);
    int code = EXIT_SUCCESS;
    try {
        run(window, argc > 1 ? argv[1] : "plaza:4096", argc > 2 ? std::atoi(argv[2]) : 0,
            argc > 3 ? argv[3] : nullptr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "embed_glfw: %s\n", error.what());
        code = EXIT_FAILURE;
    }
    glfwTerminate();
    return code;
}
