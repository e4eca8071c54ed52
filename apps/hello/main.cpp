/// The smallest program that draws a picture with candela: 256 lights, into hello.png.

#include <candela/candela.h>

#include <iostream>

int main() {
    try {
        const candela::PluginRegistry plugins;
        const candela::Scene scene = candela::importScene(plugins, "plaza:256").scene;
        const candela::ColorConfig color = candela::ColorConfig::builtIn();
        const candela::DisplayTransform display = color.displayTransform({});

        const candela::Context context = candela::Context::createHeadless();
        candela::GpuScene gpuScene(context, scene, {.workingFromRec709 = color.workingFromRec709()});
        candela::Renderer renderer(context);

        const candela::CameraView view = candela::cameraView(scene, 0, candela::worldTransforms(scene));
        const candela::Frame frame = renderer.render(gpuScene, view, {.width = 640, .height = 360});
        candela::writePng("hello.png", 640, 360, frame.displayPicture(display), display.encoding());
        std::cout << "hello.png: 256 lights on " << context.renderer() << "\n";
    } catch (const candela::Error& error) {
        std::cerr << "hello: " << error.what() << "\n";
        return 1;
    }
}
