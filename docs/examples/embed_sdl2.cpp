// A window of SDL2: the host draws within the frame, before the display transform, by a hook. What it draws
// is scene-linear light, tone-mapped with the scene. Run as `embed_sdl2 [SCENE [FRAMES [PICTURE.png]]]`.

#include <candela/candela.h>

#include <epoxy/gl.h>

#define SDL_MAIN_HANDLED
#include <SDL.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

namespace {

void savePicture(const char* path, int width, int height) {
    std::vector<std::uint8_t> rgba(std::size_t{4} * std::size_t(width) * std::size_t(height)), turned;
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    const auto row = std::ptrdiff_t{4} * width;
    for (int y = height; y-- > 0;)
        turned.insert(turned.end(), rgba.begin() + y * row, rgba.begin() + (y + 1) * row);
    candela::writePng(path, std::uint32_t(width), std::uint32_t(height), turned, {});
}

bool wantsToClose() {
    SDL_Event event;
    while (SDL_PollEvent(&event) != 0)
        if (event.type == SDL_QUIT) return true;
    return false;
}

void run(SDL_Window* window, const char* sceneName, int frames, const char* picture) {
    const candela::Context context = candela::Context::adoptCurrent();
    const candela::Scene scene = candela::importScene(candela::PluginRegistry(), sceneName).scene;
    const candela::ColorConfig color = candela::ColorConfig::builtIn();
    const candela::DisplayTransform display = color.displayTransform({});
    candela::GpuScene gpuScene(context, scene, {.workingFromRec709 = color.workingFromRec709()});
    candela::Renderer renderer(context);
    const candela::CameraView view = candela::cameraView(scene, 0, candela::worldTransforms(scene));

    candela::FrameSettings settings;
    // A bar of magenta light over the scene: a clear within a scissor needs no program.
    settings.hooks.beforeDisplay = [](const candela::FrameStage& stage) {
        const float magenta[]{2.0f, 0.0f, 2.0f, 1.0f};
        glEnable(GL_SCISSOR_TEST);
        glScissor(stage.width / 4, stage.height / 4, stage.width / 2, stage.height / 16);
        glClearBufferfv(GL_COLOR, 0, magenta);
    };
    for (int i = 0; (frames == 0 || i < frames) && !wantsToClose(); ++i) {
        SDL_GL_GetDrawableSize(window, &settings.width, &settings.height);
        if (settings.width < 1 || settings.height < 1) continue;
        renderer.render(gpuScene, view, settings).display(display, {});
        if (picture != nullptr && i + 1 == frames) savePicture(picture, settings.width, settings.height);
        SDL_GL_SwapWindow(window);
    }
}

}  // namespace

int main(int argc, char** argv) {
    SDL_SetMainReady();
    if (SDL_Init(SDL_INIT_VIDEO) != 0) return EXIT_FAILURE;
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 4);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 5);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_Window* window = SDL_CreateWindow("candela in SDL2", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED,
                                          480, 270, SDL_WINDOW_OPENGL);
    SDL_GLContext glContext = window != nullptr ? SDL_GL_CreateContext(window) : nullptr;
    int code = EXIT_FAILURE;
    if (glContext != nullptr) {
        try {
            run(window, argc > 1 ? argv[1] : "plaza:4096", argc > 2 ? std::atoi(argv[2]) : 0,
                argc > 3 ? argv[3] : nullptr);
            code = EXIT_SUCCESS;
        } catch (const std::exception& error) {
            std::fprintf(stderr, "embed_sdl2: %s\n", error.what());
        }
        SDL_GL_DeleteContext(glContext);
    } else {
        std::fprintf(stderr, "embed_sdl2: %s\n", SDL_GetError());
    }
    SDL_Quit();
    return code;
}
