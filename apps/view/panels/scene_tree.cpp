#include "panels/scene_tree.h"

#include <algorithm>
#include <numeric>

SceneTree::SceneTree(const std::vector<candela::Node>& nodes, std::size_t firstRows)
    : parents_(nodes.size(), none), firstChild_(nodes.size() + 1, 0), open_(nodes.size(), false) {
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].parent) {
            parents_[i] = *nodes[i].parent;
            ++firstChild_[parents_[i] + 1];
        } else {
            tops_.push_back(i);
        }
    }
    std::partial_sum(firstChild_.begin(), firstChild_.end(), firstChild_.begin());
    children_.resize(firstChild_.back());
    std::vector<std::uint32_t> next(firstChild_.begin(), firstChild_.end() - 1);
    for (std::uint32_t i = 0; i < nodes.size(); ++i)
        if (parents_[i] != none) children_[next[parents_[i]]++] = i;
    openFirst(firstRows);
    listRows();
}

void SceneTree::openFirst(std::size_t firstRows) {
    std::vector<std::uint32_t> level = tops_;
    std::size_t shown = level.size();
    for (std::size_t i = 0; i < level.size(); ++i) {
        const std::uint32_t node = level[i];
        const std::size_t more = firstChild_[node + 1] - firstChild_[node];
        if (shown + more > firstRows) return;
        shown += more;
        open_[node] = true;
        level.insert(level.end(), children_.begin() + firstChild_[node],
                     children_.begin() + firstChild_[node + 1]);
    }
}

void SceneTree::listRows() {
    rows_.clear();
    // From the last to the first, so that the first is on top of the stack.
    std::vector<Row> pending;
    for (auto top = tops_.rbegin(); top != tops_.rend(); ++top) pending.push_back({*top, 0});
    while (!pending.empty()) {
        const Row row = pending.back();
        pending.pop_back();
        rows_.push_back(row);
        if (!open_[row.node]) continue;
        for (std::uint32_t i = firstChild_[row.node + 1]; i > firstChild_[row.node]; --i)
            pending.push_back({children_[i - 1], row.depth + 1});
    }
}

void SceneTree::set(std::uint32_t node, Branch branch) {
    open_[node] = branch == Branch::open;
    listRows();
}

void SceneTree::setAll(std::uint32_t node, Branch branch) {
    for (const std::uint32_t one : subtree(node)) open_[one] = branch == Branch::open;
    listRows();
}

std::size_t SceneTree::reveal(std::uint32_t node) {
    for (std::uint32_t above = parents_[node]; above != none; above = parents_[above]) open_[above] = true;
    listRows();
    const auto found = std::ranges::find(rows_, node, &Row::node);
    return static_cast<std::size_t>(found - rows_.begin());
}

std::vector<std::uint32_t> SceneTree::subtree(std::uint32_t node) const {
    std::vector<std::uint32_t> nodes{node};
    for (std::size_t i = 0; i < nodes.size(); ++i)
        nodes.insert(nodes.end(), children_.begin() + firstChild_[nodes[i]],
                     children_.begin() + firstChild_[nodes[i] + 1]);
    return nodes;
}
