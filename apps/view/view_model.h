#pragma once

#include "camera_control.h"
#include "common/scene_options.h"
#include "document.h"
#include "gizmo_math.h"
#include "panels/layout.h"
#include "scene_loader.h"

#include <candela/color.h>
#include <candela/renderer.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// A line that the window shows until it is dismissed.
struct Message {
    enum class Kind { note, error } kind = Kind::note;
    std::string text;
};

/// What is dragged to move, turn or scale what is picked; see gizmo.h.
struct GizmoState {
    GizmoMode mode = GizmoMode::move;
    std::optional<GizmoHandle> hovered, dragged;
    bool tookPress = false;  ///< The last press was on an axis or a circle, and picks nothing.

    // Of the drag: what was there at its start.
    glm::vec2 from{0.0f};
    GizmoShape shape;
    candela::WorldLight light;
    glm::mat4 world{1.0f}, worldOfParent{1.0f};  ///< Of the node.

    /// The middle of the picked node, as of a revision of the document.
    struct Middle {
        std::uint32_t node = 0;
        std::uint64_t revision = 0;
        std::optional<glm::vec3> point;
    } middle;
};

/// What is shown over the picture and is no part of it.
struct Guides {
    bool outline = true;  ///< Around what is picked.
    bool lights = false;  ///< Icons of them; the picked one has its icon always.
    bool grid = false;    ///< With the axes.
};

/// A procedural scene that is offered while none is open.
struct Example {
    std::string scene;     ///< That is opened.
    std::string small;     ///< The same, or less of it, of which the picture is.
    unsigned texture = 0;  ///< The picture, 16:9; 0 until it is drawn.
};

/// Small pictures of what lists offer, as GL textures of 16:9; 0 until one is drawn. They are drawn while
/// nothing else is, of the lists that are open.
struct Thumbnails {
    std::vector<unsigned> cameras;                     ///< In the order of the scene's; it may be shorter.
    std::vector<unsigned> variants;                    ///< The first is the scene without a variant.
    bool camerasShown = false, variantsShown = false;  ///< By the panels of this frame.
};

/// Two settings side by side; see comparison.h.
struct Comparison {
    bool shown = false;
    float line = 0.5f;       ///< Between the sides, as a share of the picture's width.
    SceneOptions left;       ///< Of these the left side takes what is compared.
    bool dragged = false;    ///< The pointer holds the line.
    bool tookPress = false;  ///< The last press was on the line, and picks nothing.
};

/// What the last frames took, for the running graph.
struct FrameRecord {
    std::vector<candela::PassTime> passes;
    double milliseconds = 0.0;
};

/// Which panels are open; kept in the settings. The timeline shows where time changes something.
struct OpenPanels {
    bool scene = true, material = false, lights = true, camera = true, color = true, drawing = true,
         statistics = false, probe = false, timeline = true;
};

/// What the panels ask the application to do once they are drawn: it touches files, threads or the device.
struct Requests {
    std::optional<std::string> open;             ///< A file or a procedural scene.
    std::optional<std::string> openEnvironment;  ///< A picture of linear light.
    bool cancelLoading = false;
    bool frameAll = false, framePicked = false;
    std::optional<glm::ivec2> pick;  ///< What this pixel shows.
    bool countPairs = false;
    bool measureExposure = false;
    std::optional<std::string> variant;           ///< Show this variant, a number; empty: none.
    std::optional<std::string> ocioConfig;        ///< Read this OpenColorIO config.
    std::optional<std::string> savePng, saveExr;  ///< Write the picture here.
    std::optional<std::string> saveLights;        ///< Write lights and cameras here, as glTF.
    bool copyCommand = false;
    bool quit = false;
    bool browse = false;  ///< Show the file browser.
};

/// All that the window shows. The panels read and change it; the application draws it.
struct ViewModel {
    /// What candela-render would be given for this picture, the camera included: a camera that was moved by
    /// the user is its `eye`.
    SceneOptions options;
    CameraControl camera;  ///< The interactive camera; see interaction.h.
    bool playing = false;  ///< Time advances.

    candela::ColorConfig color = candela::ColorConfig::builtIn();
    std::unique_ptr<Document> document;  ///< Null until the first scene is there.
    std::optional<LoadStatus> loading;   ///< While a scene is being read.
    std::string loadingEnvironment;      ///< The picture that is being read; empty where none is.

    std::optional<glm::ivec2> pointer;  ///< The pixel under the pointer, from the top; none over a panel.
    std::optional<std::uint32_t> pickedNode, pickedLight, pickedMaterial;
    std::optional<candela::PixelProbe> probe;  ///< Under the pointer, while its panel is open.
    glm::vec3 probeDisplay{0.0f};              ///< Its display value, 0 to 1.

    std::deque<FrameRecord> frames;            ///< The latest last; at most 240.
    std::optional<candela::PairCounts> pairs;  ///< Of the resting picture, when the statistics are open.
    candela::LayerCounts layerCounts;          ///< Of the last frame.
    std::uint32_t maxLightCount = 0;           ///< End of the heat map.
    std::uint32_t samples = 0;                 ///< Of the picture that is shown.
    int divisor = 1;       ///< The last picture's width and height were divided by it while the camera moves.
    std::string renderer;  ///< GL_RENDERER.
    candela::Technique technique = candela::Technique::automatic;  ///< That the last frame used.

    std::vector<std::string> sceneEndings;  ///< Of the files that plugins read, such as ".gltf".

    std::vector<Example> examples;

    std::optional<bool> background;  ///< Whether the environment is seen; none where there is none.

    Thumbnails thumbnails;
    Comparison comparison;

    Guides guides;
    GizmoState gizmo;
    OpenPanels panels;
    bool helpShown = false, aboutShown = false;
    bool panelsHidden = false;  ///< With the menu bar.
    float textScale = 1.0f;     ///< Of all panels, 0.5 to 3.
    DockSizes dockSizes;
    Layout layout;                ///< Of this frame.
    glm::ivec2 windowSize{0};     ///< Of its framebuffer, in pixels.
    glm::ivec2 pictureCorner{0};  ///< The picture's upper left pixel in it; its size is that of the options.
    std::vector<std::string> recent;  ///< Scenes opened, the latest first; at most 10.
    std::deque<Message> messages;
    std::string shaderError;  ///< Of the last reload; empty when it went well.
    Requests requests;
};
