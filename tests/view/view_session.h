#pragma once

#include "application.h"
#include "picture_reader.h"
#include "scoped_environment.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

/// candela-view in this process, with its loop run by the test. Its panels are hidden, so that the picture
/// fills the window. A step fails the test when it causes a GL error.
class ViewSession {
  public:
    /// `arguments` are those of the command line; without --samples a pixel has one,
    /// without --exposure none is measured.
    explicit ViewSession(const std::vector<std::string>& arguments);
    ~ViewSession();

    Application& application() { return *application_; }
    ViewModel& model() { return application_->model(); }
    GLFWwindow* window() { return window_; }
    Document& document() { return *model().document; }

    /// Runs one iteration of the loop.
    void step(int times = 1);
    /// Iterates until `reached` holds; false when that takes a minute.
    bool stepUntil(const std::function<bool()>& reached);
    /// Iterates until loading has ended, with the scene, the environment or a message.
    void awaitScene();
    /// Waits until sent input has taken effect.
    void settle();
    /// Iterates as the program does, until it would sleep.
    void stepUntilIdle();
    /// Sends input in one call of xdotool, without a pause, and iterates until the window has handled it.
    void sendFast(const std::string& arguments);
    /// A number that changes with anything that the panels show.
    std::size_t panelsHash() const;

    void drop(const std::string& file);
    void resize(int width, int height);
    /// Moves the pointer to a pixel of the window.
    void pointTo(int x, int y);
    /// Presses the button, moves the pointer, and releases it.
    void drag(int button, int fromX, int fromY, int toX, int toY);
    void click(int x, int y);

    /// The picture as "Save PNG" writes it.
    PngPicture picture();
    /// What the window shows, panels included, as of the last step.
    PngPicture shown() const;
    /// The clipboard after "Copy candela-render command".
    std::string copiedCommand();

    std::size_t messages(Message::Kind kind);

  private:
    std::unique_ptr<Application> application_;
    GLFWwindow* window_ = nullptr;
    TemporaryFolder pictures_;
    std::size_t glErrors_ = 0;
};

/// A folder with the sample scene ("square.gltf") in it, which is the working directory while the test runs;
/// settings go into it too.
class ViewTest : public testing::Test {
  protected:
    ViewTest();
    ~ViewTest() override;
    void SetUp() override;

    /// The image that candela-render draws with these arguments, given without -o; without --samples of one
    /// sample a pixel.
    PngPicture rendered(std::vector<std::string> arguments) const;
    /// The image that a copied command draws.
    PngPicture renderedBy(const std::string& command) const;

    TemporaryFolder folder;

  private:
    std::filesystem::path before_;
    ScopedEnvironment config_;
};

/// Small enough to be drawn fast, large enough for the panels.
constexpr const char* smallSize = "320x240";

/// The largest difference of two pictures in code values; 256 when their sizes differ.
int maxDifference(const PngPicture& a, const PngPicture& b);
