#include "panels/panel_values.h"
#include "panels/panels.h"
#include "panels/scene_tree.h"
#include "panels/widgets.h"

#include <imgui.h>

#include <algorithm>

namespace {

using Visibility = candela::GpuScene::Visibility;
using Branch = SceneTree::Branch;

constexpr std::size_t firstRows = 40;
/// Height of the notes under the tree, in lines.
constexpr std::size_t maxNoteLines = 4;

struct Kept {
    SceneTree tree;
    std::vector<std::string> kinds;
    std::optional<std::uint32_t> shownPick;  ///< The picked node that the list was scrolled to.
    bool initialized = false;
};

class TreeList {
  public:
    TreeList(ViewModel& model, Kept& kept)
        : model_(model), kept_(kept), document_(*model.document), nodes_(document_.scene().nodes) {}

    void draw() {
        // Rows are as low as text: a tree shows as much as it can.
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, 0.0f});
        scrollToPicked();
        ImGuiListClipper clipper;
        // Opened and closed only when all rows are drawn: the list must not change below the clipper.
        clipper.Begin(static_cast<int>(kept_.tree.rows().size()), ImGui::GetFrameHeightWithSpacing());
        while (clipper.Step())
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
                drawRow(kept_.tree.rows()[static_cast<std::size_t>(i)]);
        ImGui::PopStyleVar();
        if (toggled_) kept_.tree.set(*toggled_, kept_.tree.isOpen(*toggled_) ? Branch::closed : Branch::open);
        if (branch_) kept_.tree.setAll(branch_->node, branch_->wanted);
    }

  private:
    struct BranchChange {
        std::uint32_t node;
        Branch wanted;
    };

    void scrollToPicked() {
        if (model_.pickedNode == kept_.shownPick) return;
        kept_.shownPick = model_.pickedNode;
        if (!model_.pickedNode) return;
        const float row = static_cast<float>(kept_.tree.reveal(*model_.pickedNode));
        ImGui::SetScrollY(row * ImGui::GetFrameHeightWithSpacing() - 0.5f * ImGui::GetWindowHeight());
    }

    void drawRow(const SceneTree::Row& row) {
        ImGui::PushID(static_cast<int>(row.node));
        const float indent = static_cast<float>(row.depth) * ImGui::GetFontSize();
        drawBox(row.node);
        ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x + indent);
        drawName(row.node);
        ImGui::PopID();
    }

    /// A group's own visibility hides nothing, so that its box controls the whole subtree.
    void drawBox(std::uint32_t node) {
        const bool shows = nodes_[node].mesh || nodes_[node].cage;
        if (!shows && !kept_.tree.hasChildren(node)) {
            ImGui::Dummy({ImGui::GetFrameHeight(), ImGui::GetFrameHeight()});
            return;
        }
        bool visible = document_.visibility(node) == Visibility::shown;
        if (!ImGui::Checkbox("##visible", &visible)) return;
        const Visibility wanted = visible ? Visibility::shown : Visibility::hidden;
        if (ImGui::GetIO().KeyCtrl || !shows) {
            setBelow(node, wanted);
        } else {
            document_.setVisibility(node, wanted);
        }
    }

    void drawName(std::uint32_t node) {
        ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_OpenOnArrow |
                                   ImGuiTreeNodeFlags_OpenOnDoubleClick | ImGuiTreeNodeFlags_SpanAvailWidth;
        if (!kept_.tree.hasChildren(node)) flags |= ImGuiTreeNodeFlags_Leaf;
        if (model_.pickedNode == node) flags |= ImGuiTreeNodeFlags_Selected;
        const bool open = kept_.tree.isOpen(node);
        ImGui::SetNextItemOpen(open);
        const std::string& name = nodes_[node].name;
        const std::string text = name.empty() ? elementText("node", node, "") : name;
        const bool opened = ImGui::TreeNodeEx("##name", flags, "%s", text.c_str());
        if (opened != open && kept_.tree.hasChildren(node)) toggled_ = node;
        if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) {
            model_.pickedNode = node;
            model_.pickedLight.reset();
            kept_.shownPick = node;
        }
        drawMenu(node);
        if (kept_.kinds[node].empty()) return;
        ImGui::SameLine();
        showDimText(kept_.kinds[node]);
    }

    void drawMenu(std::uint32_t node) {
        if (!ImGui::BeginPopupContextItem("menu")) return;
        if (ImGui::MenuItem("Show it and all below")) setBelow(node, Visibility::shown);
        if (ImGui::MenuItem("Hide it and all below")) setBelow(node, Visibility::hidden);
        ImGui::Separator();
        if (ImGui::MenuItem("Open all below")) branch_ = {node, Branch::open};
        if (ImGui::MenuItem("Close all below")) branch_ = {node, Branch::closed};
        ImGui::Separator();
        if (ImGui::MenuItem("Frame it")) {
            model_.pickedNode = node;
            model_.requests.framePicked = true;
        }
        ImGui::EndPopup();
    }

    void setBelow(std::uint32_t node, Visibility visibility) {
        for (const std::uint32_t one : kept_.tree.subtree(node))
            if (document_.visibility(one) != visibility) document_.setVisibility(one, visibility);
    }

    ViewModel& model_;
    Kept& kept_;
    Document& document_;
    const std::vector<candela::Node>& nodes_;
    std::optional<std::uint32_t> toggled_;
    std::optional<BranchChange> branch_;
};

void drawNotes(const std::vector<candela::ImportNote>& notes) {
    ImGui::Separator();
    ImGui::BeginChild("notes");
    for (const candela::ImportNote& note : notes) showWrappedText(note.line());
    ImGui::EndChild();
}

float notesHeight(const std::vector<candela::ImportNote>& notes) {
    if (notes.empty()) return 0.0f;
    const auto lines = static_cast<float>(std::min(2 * notes.size(), maxNoteLines));
    return lines * ImGui::GetTextLineHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
}

}  // namespace

void drawScenePanel(ViewModel& model) {
    const PanelWindow window(model, Panel::scene, "Scene");
    if (!window || !model.document) return;
    const Document& document = *model.document;
    auto& kept = keptOfScene<Kept>(model);
    if (!kept.initialized) {
        kept.tree = SceneTree(document.scene().nodes, firstRows);
        kept.kinds = kindsOfNodes(document.scene());
        kept.initialized = true;
    }
    ImGui::BeginChild("tree", {0.0f, -notesHeight(document.notes())});
    TreeList(model, kept).draw();
    ImGui::EndChild();
    if (!document.notes().empty()) drawNotes(document.notes());
}
