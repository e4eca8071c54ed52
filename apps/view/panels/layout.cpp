#include "panels/layout.h"

#include <algorithm>

namespace {

using State = PanelStates::State;

/// A dock takes no more of the window, so that the picture has the larger part.
constexpr float largestShare = 0.3f;
/// The smallest dock, in letters.
constexpr float minDock = 6.0f;
/// The smallest panel, as a share of its dock.
constexpr float minShare = 0.08f;
/// Height of the timeline, in heights of a title.
constexpr float rowHeights = 1.7f;
/// Width of a splitter, in letters.
constexpr float splitterLetters = 0.35f;

std::size_t indexOf(Panel panel) {
    return static_cast<std::size_t>(panel);
}

std::vector<Panel> panelsIn(Dock dock, const PanelStates& states) {
    std::vector<Panel> panels;
    for (std::size_t i = 0; i < panelCount; ++i)
        if (dockOf(Panel(i)) == dock && states.of[i] != State::closed) panels.push_back(Panel(i));
    return panels;
}

/// Lays panels one behind another along an axis: 0 side by side, 1 one under another.
class Stack {
  public:
    Stack(Dock dock, int axis, const PanelSpace& space, const PanelStates& states, const DockSizes& sizes)
        : dock_(dock), axis_(axis), space_(space), states_(states), sizes_(sizes) {}

    void lay(const PanelPlace& place, Layout& layout) const {
        const std::vector<Panel> panels = panelsIn(dock_, states_);
        const float gap = splitterLetters * space_.letter;
        const float gaps = gap * static_cast<float>(panels.size() - 1);
        float room = place.size[axis_] - gaps, weights = 0.0f;
        for (const Panel panel : panels) {
            if (collapses(panel)) {
                room -= space_.titleHeight;
            } else {
                weights += sizes_.weights[indexOf(panel)];
            }
        }
        PanelPlace next = place;
        for (std::size_t i = 0; i < panels.size(); ++i) {
            const float share = sizes_.weights[indexOf(panels[i])] / std::max(weights, 1.0e-6f);
            next.size[axis_] =
                collapses(panels[i]) ? space_.titleHeight : std::max(share * std::max(room, 0.0f), 1.0f);
            layout.panels[indexOf(panels[i])] = next;
            next.position[axis_] += next.size[axis_];
            if (i + 1 == panels.size()) break;
            next.size[axis_] = gap;
            layout.splitters.push_back({next, dock_, Splitter::Kind::between, panels[i], panels[i + 1]});
            next.position[axis_] += gap;
        }
    }

  private:
    /// Side by side, a collapsed panel keeps its width: its title is as wide.
    bool collapses(Panel panel) const { return axis_ == 1 && states_.of[indexOf(panel)] == State::collapsed; }

    Dock dock_;
    int axis_;
    const PanelSpace& space_;
    const PanelStates& states_;
    const DockSizes& sizes_;
};

float& sizeOf(Dock dock, DockSizes& sizes) {
    if (dock == Dock::left) return sizes.left;
    return dock == Dock::right ? sizes.right : sizes.bottom;
}

int axisOfSize(Dock dock) {
    return dock == Dock::bottom ? 1 : 0;
}

}  // namespace

Dock dockOf(Panel panel) {
    switch (panel) {
        case Panel::scene:
        case Panel::materials:
        case Panel::lights:
            return Dock::left;
        case Panel::camera:
        case Panel::color:
        case Panel::drawing:
            return Dock::right;
        case Panel::timeline:
            return Dock::row;
        default:
            return Dock::bottom;
    }
}

Layout layoutOf(const PanelSpace& space, const PanelStates& states, const DockSizes& sizes) {
    Layout layout;
    layout.picture = {{0.0f, space.menuHeight}, {space.display.x, space.display.y - space.menuHeight}};
    PanelPlace& free = layout.picture;
    const float gap = splitterLetters * space.letter;
    for (const Dock dock : {Dock::left, Dock::right, Dock::bottom}) {
        if (panelsIn(dock, states).empty()) continue;
        const int axis = axisOfSize(dock);
        DockSizes copy = sizes;
        const float size = std::min(sizeOf(dock, copy) * space.letter, largestShare * space.display[axis]);
        PanelPlace place = free, bar = free;
        place.size[axis] = size;
        bar.size[axis] = gap;
        free.size[axis] -= size + gap;
        if (dock == Dock::left) {
            bar.position.x += size;
            free.position.x += size + gap;
        } else {
            bar.position[axis] = free.position[axis] + free.size[axis];
            place.position[axis] = bar.position[axis] + gap;
        }
        layout.splitters.push_back({bar, dock, Splitter::Kind::dockSize, {}, {}});
        Stack(dock, 1 - axis, space, states, sizes).lay(place, layout);
    }
    if (states.of[indexOf(Panel::timeline)] != State::closed) {
        const float height = std::min(rowHeights * space.titleHeight, largestShare * space.display.y);
        free.size.y -= height;
        layout.panels[indexOf(Panel::timeline)] = {{free.position.x, free.position.y + free.size.y},
                                                   {free.size.x, height}};
    }
    free.size = {std::max(free.size.x, 1.0f), std::max(free.size.y, 1.0f)};
    return layout;
}

void moveSplitter(const Splitter& splitter, const glm::vec2& units, const Layout& layout,
                  const PanelSpace& space, DockSizes& sizes) {
    const int axis = axisOfSize(splitter.dock);
    if (splitter.kind == Splitter::Kind::dockSize) {
        const float sign = splitter.dock == Dock::left ? 1.0f : -1.0f;
        float& size = sizeOf(splitter.dock, sizes);
        const float largest = largestShare * space.display[axis] / space.letter;
        // A size that was larger than the window allows is moved from where it shows.
        const float moved = std::min(size, largest) + sign * units[axis] / space.letter;
        size = std::clamp(moved, std::min(minDock, largest), largest);
        return;
    }
    float& first = sizes.weights[indexOf(splitter.first)];
    float& second = sizes.weights[indexOf(splitter.second)];
    const float both = layout.panels[indexOf(splitter.first)].size[1 - axis] +
                       layout.panels[indexOf(splitter.second)].size[1 - axis];
    const float sum = first + second;
    const float moved = first + units[1 - axis] / std::max(both, 1.0f) * sum;
    first = std::clamp(moved, minShare * sum, (1.0f - minShare) * sum);
    second = sum - first;
}
