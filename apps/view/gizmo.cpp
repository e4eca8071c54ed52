#include "gizmo.h"

#include "interaction.h"
#include "panels/panel.h"

#include <imgui.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <array>

namespace {

/// In heights of a letter: the length of an axis, and how near to it the pointer takes it.
constexpr float axisLetters = 5.5f, reachLetters = 0.6f;
constexpr std::array handles{GizmoHandle::x, GizmoHandle::y, GizmoHandle::z};

ScreenView screenOf(const ViewModel& model) {
    return {selectedView(model), model.layout.picture.position, model.layout.picture.size};
}

glm::vec2 pointerOf(const ImGuiIO& io) {
    return {io.MousePos.x, io.MousePos.y};
}

/// What a gizmo moves: a light that has a place, or a node that its own matrix places.
bool movesLight(const ViewModel& model) {
    return model.pickedLight && *model.pickedLight < model.document->lights().size();
}

std::optional<glm::vec3> originOfLight(const ViewModel& model) {
    const candela::WorldLight& light = model.document->lights()[*model.pickedLight];
    const bool canTurn = light.type == candela::LightType::spot;
    if (light.type == candela::LightType::directional || model.document->lightMotion().moving ||
        model.gizmo.mode == GizmoMode::scale || (model.gizmo.mode == GizmoMode::turn && !canTurn))
        return std::nullopt;
    return light.position;
}

/// The middle of the node's box: files often have all their nodes at their origin.
std::optional<glm::vec3> originOfNode(ViewModel& model) {
    const std::uint32_t node = *model.pickedNode;
    if (model.document->scene().nodes[node].skin) return std::nullopt;
    GizmoState::Middle& middle = model.gizmo.middle;
    const std::uint64_t revision = model.document->revision();
    if (middle.node != node || middle.revision != revision || !middle.point) {
        const candela::Bounds box = model.document->bounds(node);
        middle = {node, revision, std::nullopt};
        if (!box.empty()) middle.point = 0.5f * (box.min + box.max);
    }
    return middle.point;
}

std::optional<glm::vec3> originOf(ViewModel& model) {
    if (movesLight(model)) return originOfLight(model);
    return model.pickedNode ? originOfNode(model) : std::nullopt;
}

void begin(ViewModel& model, GizmoHandle handle, const GizmoShape& shape, const ImGuiIO& io) {
    GizmoState& gizmo = model.gizmo;
    gizmo.dragged = handle;
    gizmo.tookPress = handle != GizmoHandle::middle;
    gizmo.from = pointerOf(io);
    gizmo.shape = shape;
    if (movesLight(model)) {
        gizmo.light = model.document->lights()[*model.pickedLight];
        return;
    }
    const candela::Scene& scene = model.document->scene();
    const auto world = candela::worldTransforms(scene, model.document->time());
    const auto& parent = scene.nodes[*model.pickedNode].parent;
    gizmo.world = world[*model.pickedNode];
    gizmo.worldOfParent = parent ? world[*parent] : glm::mat4(1.0f);
}

void apply(ViewModel& model, const glm::mat4& change) {
    const GizmoState& gizmo = model.gizmo;
    if (movesLight(model)) {
        candela::WorldLight light = gizmo.light;
        light.position = glm::vec3(change * glm::vec4(light.position, 1.0f));
        light.direction = glm::normalize(glm::mat3(change) * light.direction);
        return tryTo(model, [&] { model.document->setLight(*model.pickedLight, light); });
    }
    const glm::mat4 local = glm::inverse(gizmo.worldOfParent) * change * gizmo.world;
    tryTo(model, [&] { model.document->setTransform(*model.pickedNode, local); });
}

ImU32 colorOf(const GizmoState& gizmo, GizmoHandle handle) {
    if (gizmo.dragged ? gizmo.dragged == handle : gizmo.hovered == handle)
        return IM_COL32(255, 255, 255, 255);
    constexpr std::array colors{IM_COL32(226, 84, 84, 255), IM_COL32(112, 192, 88, 255),
                                IM_COL32(88, 136, 232, 255), IM_COL32(224, 200, 150, 255)};
    return colors[static_cast<std::size_t>(handle)];
}

void drawCircle(ImDrawList& list, const ScreenView& screen, const GizmoShape& shape, GizmoHandle axis,
                ImU32 color) {
    const auto points = circlePoints(shape, axis);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const auto from = screen.at(points[i - 1]), to = screen.at(points[i]);
        if (from && to) list.AddLine({from->x, from->y}, {to->x, to->y}, color, 2.0f);
    }
}

void drawAxis(ImDrawList& list, const ScreenView& screen, const GizmoShape& shape, GizmoMode mode,
              GizmoHandle axis, ImU32 color) {
    glm::vec3 end = shape.origin;
    end[static_cast<int>(axis)] += shape.metres;
    const auto from = screen.at(shape.origin), to = screen.at(end);
    if (!from || !to) return;
    list.AddLine({from->x, from->y}, {to->x, to->y}, color, 2.0f);
    const float size = 0.35f * ImGui::GetFontSize();
    if (mode == GizmoMode::scale) {
        list.AddRectFilled({to->x - size, to->y - size}, {to->x + size, to->y + size}, color);
        return;
    }
    const float length = glm::distance(*from, *to);
    if (length < 1.0f) return;
    const glm::vec2 along = (*to - *from) / length, across(-along.y, along.x);
    const glm::vec2 tip = *to + 2.0f * size * along, a = *to + size * across, b = *to - size * across;
    list.AddTriangleFilled({tip.x, tip.y}, {a.x, a.y}, {b.x, b.y}, color);
}

void draw(const ScreenView& screen, const GizmoShape& shape, const GizmoState& gizmo) {
    const auto middle = screen.at(shape.origin);
    if (!middle) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (const GizmoHandle handle : handles) {
        const ImU32 color = colorOf(gizmo, handle);
        if (gizmo.mode == GizmoMode::turn) {
            drawCircle(list, screen, shape, handle, color);
        } else {
            drawAxis(list, screen, shape, gizmo.mode, handle, color);
        }
    }
    if (gizmo.mode != GizmoMode::turn)
        list.AddCircleFilled({middle->x, middle->y}, 0.35f * ImGui::GetFontSize(),
                             colorOf(gizmo, GizmoHandle::middle));
}

}  // namespace

bool driveGizmo(ViewModel& model) {
    GizmoState& gizmo = model.gizmo;
    const ImGuiIO& io = ImGui::GetIO();
    const bool down = io.MouseDown[0];
    const std::optional<glm::vec3> origin = originOf(model);
    if (!origin || !down) gizmo.dragged.reset();
    if (ImGui::IsMouseClicked(0)) gizmo.tookPress = false;
    gizmo.hovered.reset();
    if (!origin) return false;
    const ScreenView screen = screenOf(model);
    const float letter = ImGui::GetFontSize();
    const GizmoShape shape{*origin, screen.metresAt(*origin, axisLetters * letter)};
    if (!io.WantCaptureMouse && !down)
        gizmo.hovered = handleAt(screen, shape, gizmo.mode, pointerOf(io), reachLetters * letter);
    if (ImGui::IsMouseClicked(0) && !io.MouseDownOwned[0] && !io.KeyShift) {
        const auto handle = handleAt(screen, shape, gizmo.mode, pointerOf(io), reachLetters * letter);
        if (handle) begin(model, *handle, shape, io);
    }
    if (gizmo.dragged && (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f))
        apply(model, dragged(screen, gizmo.shape, gizmo.mode, *gizmo.dragged, gizmo.from, pointerOf(io)));
    draw(screen, shape, gizmo);
    return gizmo.dragged.has_value();
}
