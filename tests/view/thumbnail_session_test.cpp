// Small pictures of cameras and variants, drawn while the list that shows them is open.

#include "view_session.h"

#include <epoxy/gl.h>
#include <imgui_internal.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace {

constexpr const char* size = "256x144";

PngPicture pictureOf(unsigned texture) {
    PngPicture picture{256, 144, std::vector<std::uint8_t>(std::size_t{4} * 256 * 144)};
    glGetTextureImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(picture.rgba.size()),
                      picture.rgba.data());
    return picture;
}

class ThumbnailSession : public ViewTest {
  protected:
    void open(const std::string& scene) {
        session = std::make_unique<ViewSession>(std::vector<std::string>{scene, "--size", "640x480"});
        session->model().panels = {.scene = false, .lights = false, .color = false, .drawing = false};
        session->model().panelsHidden = false;
        session->awaitScene();
        session->stepUntilIdle();
    }
    const Thumbnails& thumbnails() { return session->model().thumbnails; }

    std::unique_ptr<ViewSession> session;
};

TEST_F(ThumbnailSession, CamerasAreDrawnOnceTheirListIsOpen) {
    open("square.gltf");
    EXPECT_TRUE(thumbnails().cameras.empty());
    const ImGuiWindow* panel = ImGui::FindWindowByName("Camera");
    ASSERT_NE(panel, nullptr);
    const auto left = static_cast<int>(panel->Pos.x), top = static_cast<int>(panel->Pos.y);
    for (int y = top + 20; y < top + 60 && !thumbnails().camerasShown; y += 6) session->click(left + 20, y);
    ASSERT_TRUE(thumbnails().camerasShown);
    session->stepUntilIdle();
    ASSERT_EQ(thumbnails().cameras.size(), 2u);
    const auto expected = [&](const std::string& camera) {
        return rendered({"square.gltf", "--size", size, "--camera", camera});
    };
    EXPECT_EQ(maxDifference(pictureOf(thumbnails().cameras[0]), expected("0")), 0);
    EXPECT_EQ(maxDifference(pictureOf(thumbnails().cameras[1]), expected("1")), 0);

    // Drawn again once the scene is another, and only then.
    const PngPicture before = pictureOf(thumbnails().cameras[0]);
    session->step(3);
    EXPECT_TRUE(session->application().isIdle());
    candela::WorldLight light = session->document().lights()[0];
    light.intensity *= 4.0f;
    session->document().setLight(0, light);
    session->step();
    session->stepUntilIdle();
    EXPECT_GT(maxDifference(pictureOf(thumbnails().cameras[0]), before), 0);
    session->model().requests.open = "square.gltf";
    session->awaitScene();
    EXPECT_TRUE(thumbnails().cameras.size() < 2 || thumbnails().camerasShown);
}

TEST_F(ThumbnailSession, VariantsAreDrawnWithoutBeingShown) {
    nlohmann::json scene = nlohmann::json::parse(std::ifstream(folder / "square.gltf"));
    scene["extensionsUsed"].push_back("KHR_materials_variants");
    scene["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "red"}}};
    scene["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}}}});
    scene["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"] = {
        {{"material", 1}, {"variants", {0}}}};
    folder.write("variants.gltf", scene.dump());
    open("variants.gltf");
    const PngPicture shown = session->picture();
    for (int x = 10; x < 400 && !thumbnails().variantsShown; x += 10) session->click(x, 9);
    ASSERT_TRUE(thumbnails().variantsShown);
    session->stepUntilIdle();
    ASSERT_EQ(thumbnails().variants.size(), 2u);
    const auto expected = [&](const std::vector<std::string>& variant) {
        std::vector<std::string> arguments{"variants.gltf", "--size", size, "--shadows", "off"};
        arguments.insert(arguments.end(), variant.begin(), variant.end());
        return rendered(arguments);
    };
    EXPECT_EQ(maxDifference(pictureOf(thumbnails().variants[0]), expected({})), 0);
    EXPECT_EQ(maxDifference(pictureOf(thumbnails().variants[1]), expected({"--variant", "red"})), 0);
    EXPECT_FALSE(session->model().options.variant);
    EXPECT_EQ(maxDifference(session->picture(), shown), 0);
}

}  // namespace
