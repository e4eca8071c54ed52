#pragma once

#include <candela/scene.h>

#include <cstdint>
#include <vector>

/// The nodes of a scene as the lines of a tree, of which branches open and close. Costs as much as there are
/// lines when it changes, and nothing when it does not.
class SceneTree {
  public:
    SceneTree() = default;
    /// Opens branches from the top as long as there are no more than `firstRows` lines.
    SceneTree(const std::vector<candela::Node>& nodes, std::size_t firstRows);

    struct Row {
        std::uint32_t node = 0;
        std::uint32_t depth = 0;  ///< 0 at the top.
    };
    /// The lines that show, from above.
    const std::vector<Row>& rows() const { return rows_; }

    bool hasChildren(std::uint32_t node) const { return firstChild_[node] < firstChild_[node + 1]; }
    bool isOpen(std::uint32_t node) const { return open_[node]; }

    enum class Branch { closed, open };
    void set(std::uint32_t node, Branch branch);
    /// And all branches on it.
    void setAll(std::uint32_t node, Branch branch);
    /// Opens the ancestors of the node. Returns its line.
    std::size_t reveal(std::uint32_t node);

    /// The node and its descendants, parents first.
    std::vector<std::uint32_t> subtree(std::uint32_t node) const;

  private:
    void openFirst(std::size_t firstRows);
    void listRows();

    static constexpr std::uint32_t none = 0xffffffffu;
    std::vector<std::uint32_t> parents_;  ///< `none` at the top.
    std::vector<std::uint32_t> tops_;
    /// The children of node n are `children_` from firstChild_[n] to firstChild_[n + 1].
    std::vector<std::uint32_t> firstChild_, children_;
    std::vector<bool> open_;
    std::vector<Row> rows_;
};
