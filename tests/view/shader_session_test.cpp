// Shaders are reloaded when a file of CANDELA_SHADER_DIR changes.

#include "view_session.h"

#include <candela/error.h>

#include <fstream>
#include <sstream>

namespace {

/// Copies the shaders into a folder from which the viewer loads them.
class ShaderSession : public ViewTest {
  protected:
    ShaderSession() : variable_("CANDELA_SHADER_DIR", folder / "shaders") {
        std::filesystem::copy(CANDELA_SHADERS, folder / "shaders", std::filesystem::copy_options::recursive);
    }

    std::string text(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream(folder / ("shaders/" + name)).rdbuf();
        return text.str();
    }
    /// Writes a shader with `line` put before its last brace.
    void insert(const std::string& name, std::string text, const std::string& line) const {
        folder.write("shaders/" + name, text.insert(text.rfind('}'), line));
    }

  private:
    ScopedEnvironment variable_;
};

bool isRed(const PngPicture& picture) {
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        if (picture.rgba[i] != 255 || picture.rgba[i + 1] != 0 || picture.rgba[i + 2] != 0) return false;
    return true;
}

constexpr const char* red = "    code = vec4(1.0, 0.0, 0.0, 1.0);\n";
/// A technique whose frames the shader `display.frag` shows on software devices, too.
constexpr const char* onDevice = "volumes";
constexpr const char* wrong = "    this is no GLSL;\n";

TEST_F(ShaderSession, ABrokenShaderIsAnErrorUntilItIsFixedAndTheLastGoodProgramStays) {
    ViewSession session({"square.gltf", "--size", smallSize, "--technique", onDevice});
    session.awaitScene();
    const PngPicture first = session.picture();
    const std::string good = text("display.frag");

    insert("display.frag", good, red);
    EXPECT_TRUE(session.stepUntil([&] { return isRed(session.picture()); }));
    EXPECT_EQ(session.model().shaderError, "");

    insert("display.frag", good, wrong);
    ASSERT_TRUE(session.stepUntil([&] { return !session.model().shaderError.empty(); }));
    EXPECT_NE(session.model().shaderError.find("display.frag"), std::string::npos)
        << session.model().shaderError;
    EXPECT_TRUE(isRed(session.picture())) << "the last good program is kept";
    session.resize(200, 160);
    EXPECT_TRUE(isRed(session.picture()));
    session.resize(320, 240);
    EXPECT_EQ(session.messages(Message::Kind::error), 0u);

    folder.write("shaders/display.frag", good);
    ASSERT_TRUE(session.stepUntil([&] { return session.model().shaderError.empty(); }));
    session.step();
    EXPECT_EQ(maxDifference(session.picture(), first), 0);
}

TEST_F(ShaderSession, IncludedAndRemovedFilesAreWatched) {
    ViewSession session({"square.gltf", "--size", smallSize});
    session.awaitScene();
    const PngPicture first = session.picture();
    const std::string good = text("lib/gbuffer.glsl");
    insert("lib/gbuffer.glsl", good, wrong);
    ASSERT_TRUE(session.stepUntil([&] { return !session.model().shaderError.empty(); }));
    EXPECT_EQ(maxDifference(session.picture(), first), 0);
    folder.write("shaders/lib/gbuffer.glsl", good);
    ASSERT_TRUE(session.stepUntil([&] { return session.model().shaderError.empty(); }));

    std::filesystem::rename(folder / "shaders/surface_plain.frag", folder / "surface_plain.frag");
    ASSERT_TRUE(session.stepUntil([&] { return !session.model().shaderError.empty(); }));
    EXPECT_NE(session.model().shaderError.find("surface_plain.frag"), std::string::npos);
    EXPECT_EQ(maxDifference(session.picture(), first), 0);
    std::filesystem::rename(folder / "surface_plain.frag", folder / "shaders/surface_plain.frag");
    ASSERT_TRUE(session.stepUntil([&] { return session.model().shaderError.empty(); }));
}

TEST_F(ShaderSession, AProgramThatIsCompiledLaterFailsWithAMessage) {
    ViewSession session({"square.gltf", "--size", smallSize});
    session.awaitScene();
    const PngPicture first = session.picture();
    insert("debug_view.frag", text("debug_view.frag"), wrong);
    session.model().options.debug.view = candela::DebugView::normals;
    ASSERT_TRUE(session.stepUntil([&] { return session.messages(Message::Kind::error) > 0; }));
    EXPECT_NE(session.model().messages.back().text.find("debug_view.frag"), std::string::npos);
    session.step(5);
    EXPECT_EQ(session.messages(Message::Kind::error), 1u) << "once, not in every frame";
    session.model().options.debug.view = candela::DebugView::none;
    session.step();
    EXPECT_EQ(maxDifference(session.picture(), first), 0);
}

TEST_F(ShaderSession, CagesAndEditsSurviveAReload) {
    ViewSession session({"sculpture:64", "--size", smallSize, "--technique", onDevice});
    session.awaitScene();
    session.document().scatterLights({.count = 40, .range = 9.0f, .candela = 20.0f, .seed = 2});
    const PngPicture first = session.picture();
    const std::string good = text("display.frag");
    insert("display.frag", good, red);
    EXPECT_TRUE(session.stepUntil([&] { return isRed(session.picture()); }));
    folder.write("shaders/display.frag", good);
    EXPECT_TRUE(session.stepUntil([&] { return !isRed(session.picture()); }));
    EXPECT_EQ(maxDifference(session.picture(), first), 0);
}

TEST_F(ShaderSession, AreReloadedWithoutAScene) {
    ViewSession session({"--size", smallSize, "--technique", onDevice});
    const std::string good = text("display.frag");
    session.step(2);
    insert("display.frag", good, red);
    session.drop("square.gltf");
    EXPECT_TRUE(session.stepUntil([&] { return isRed(session.picture()); }));
}

TEST_F(ShaderSession, AMissingFolderIsAnError) {
    const ScopedEnvironment variable("CANDELA_SHADER_DIR", folder / "nowhere");
    try {
        ViewSession session({"--size", smallSize});
        FAIL() << "there are no shaders";
    } catch (const candela::Error& error) {
        EXPECT_NE(std::string(error.what()).find("CANDELA_SHADER_DIR"), std::string::npos) << error.what();
    }
}

}  // namespace
