#pragma once

#include "scene/model/animation.h"
#include "scene/model/frame_callback.h"

#include <candela/scene.h>

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace candela {

/// The world matrices of a scene's nodes. Edits mark nodes; an update recomputes those below marked ones, and
/// no other.
class NodeTransforms {
  public:
    /// The scene has to outlive the object. The first update recomputes all nodes, as at time 0.
    explicit NodeTransforms(Scene& scene);

    /// Replaces the node's local transform. Its animations of translation, rotation and scale are removed
    /// from the scene.
    void setLocal(std::uint32_t node, const glm::mat4& local);
    /// Poses animated nodes as at `seconds`, and those that `update` names as it has them; null: none.
    void setTime(double seconds, std::shared_ptr<const SceneUpdate> update);
    double time() const { return time_; }
    /// Returns what animations move to the pose of the scene, before those that play pose it again.
    void resetAnimated();

    /// Recomputes world matrices. Returns the nodes whose matrices that were, parents before children.
    std::span<const std::uint32_t> update();

    /// Takes in a node of the scene, at the end or at the place of one that was removed. Its children come
    /// later.
    void add(std::uint32_t node);
    /// Takes out a node without children; the scene has an empty one in its place.
    void remove(std::uint32_t node);

    /// Calls `visit(child)` for the children of a node.
    template <typename Visit>
    void forEachChild(std::uint32_t node, const Visit& visit) const {
        for (std::uint32_t child = links_[node].firstChild; child != none; child = links_[child].nextSibling)
            visit(child);
    }

    /// One a node, as of the last update.
    const std::vector<glm::mat4>& world() const { return world_; }

  private:
    static constexpr std::uint32_t none = 0xffffffffu;

    void link(std::uint32_t node);
    void removeChannels(std::uint32_t node);
    void listAnimated();
    void listPlaying();
    void pose();
    void takeUpdate();
    void mark(std::uint32_t node);
    void updateAll();
    void updateSubtree(std::uint32_t root);
    void updateNode(std::uint32_t node);
    void updateFarNode(std::uint32_t node);
    /// Sets the local matrix to the pose of the scene.
    void rest(std::uint32_t node);

    Scene& scene_;
    double time_ = 0.0;
    bool timeChanged_ = true;
    std::vector<std::uint32_t> parents_;
    /// The children of a node are a list.
    struct Links {
        std::uint32_t firstChild = none, nextSibling = none, previousSibling = none;
    };
    std::vector<Links> links_;
    std::vector<bool> animated_;  ///< In translation, rotation or scale.
    std::shared_ptr<const SceneUpdate> update_;
    std::vector<std::uint32_t> given_;  ///< Nodes whose matrix is that of the update.
    std::vector<bool> isEdited_;        ///< The update does not move the node any more; empty: none.
    /// A node that playing animations move.
    struct Playing {
        PosedNode pose;                                 ///< As of the last `pose`.
        std::vector<const AnimationChannel*> channels;  ///< Of the scene; the later ones apply.
    };
    std::vector<Playing> playing_;  ///< In ascending order of nodes.
    bool playingListed_ = false;
    std::vector<glm::mat4> local_, world_;
    std::vector<glm::dmat4> exactLocal_, exactWorld_;  ///< Of a scene far from its file's origin; else empty.
    std::vector<std::uint8_t> isMarked_;
    std::vector<std::uint32_t> marked_, updated_, stack_;
};

}  // namespace candela
