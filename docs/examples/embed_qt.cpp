// A widget of Qt 5: candela draws into the framebuffer of a QOpenGLWidget. Run as `embed_qt [SCENE [FRAMES
// [PICTURE.png]]]`.

#include <candela/candela.h>

#include <QApplication>
#include <QOpenGLWidget>
#include <QSurfaceFormat>
#include <QTimer>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>

namespace {

class SceneWidget : public QOpenGLWidget {
  public:
    SceneWidget(const char* scene, int frames, const char* picture)
        : scene_(candela::importScene(candela::PluginRegistry(), scene).scene),
          frames_(frames),
          picture_(picture) {
        resize(480, 270);
    }
    SceneWidget(const SceneWidget&) = delete;
    SceneWidget& operator=(const SceneWidget&) = delete;
    ~SceneWidget() override {
        makeCurrent();  // The widget's context has to be current while its objects are destroyed.
        drawing_.reset();
        doneCurrent();
    }

    int code() const { return code_; }

  protected:
    void initializeGL() override {
        guarded([&] { drawing_.emplace(scene_); });
    }

    void paintGL() override {
        guarded([&] {
            if (!drawing_) return;
            const qreal ratio = devicePixelRatioF();
            const candela::FrameSettings settings{.width = int(width() * ratio),
                                                  .height = int(height() * ratio)};
            const candela::Frame frame =
                drawing_->renderer.render(drawing_->gpuScene, drawing_->view, settings);
            // Not 0: Qt composes widgets from framebuffers of their own.
            frame.display(drawing_->display, {.framebuffer = defaultFramebufferObject()});
            if (++drawn_ == frames_) {
                if (picture_ != nullptr)
                    candela::writePng(picture_, std::uint32_t(settings.width), std::uint32_t(settings.height),
                                      frame.displayPicture(drawing_->display), drawing_->display.encoding());
                QTimer::singleShot(0, qApp, &QApplication::quit);
            } else {
                update();
            }
        });
    }

  private:
    /// All that belongs to the widget's context.
    struct Drawing {
        explicit Drawing(const candela::Scene& scene)
            : gpuScene(context, scene, {.workingFromRec709 = color.workingFromRec709()}),
              renderer(context),
              view(candela::cameraView(scene, 0, candela::worldTransforms(scene))) {}

        candela::Context context = candela::Context::adoptCurrent();
        candela::ColorConfig color = candela::ColorConfig::builtIn();
        candela::DisplayTransform display = color.displayTransform({});
        candela::GpuScene gpuScene;
        candela::Renderer renderer;
        candela::CameraView view;
    };

    /// No exception may pass through Qt's event loop.
    template <typename Action>
    void guarded(const Action& action) {
        try {
            action();
        } catch (const std::exception& error) {
            std::fprintf(stderr, "embed_qt: %s\n", error.what());
            code_ = EXIT_FAILURE;
            QTimer::singleShot(0, qApp, &QApplication::quit);
        }
    }

    candela::Scene scene_;
    int frames_, drawn_ = 0, code_ = EXIT_SUCCESS;
    const char* picture_;
    std::optional<Drawing> drawing_;
};

}  // namespace

int main(int argc, char** argv) {
    QSurfaceFormat format;
    format.setVersion(4, 5);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QSurfaceFormat::setDefaultFormat(format);
    const QApplication application(argc, argv);
    try {
        SceneWidget widget(argc > 1 ? argv[1] : "plaza:4096", argc > 2 ? std::atoi(argv[2]) : 0,
                           argc > 3 ? argv[3] : nullptr);
        widget.show();
        QApplication::exec();
        return widget.code();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "embed_qt: %s\n", error.what());
        return EXIT_FAILURE;
    }
}
