// Panels, splitters and picture share the window.

#include "panels/layout.h"

#include <gtest/gtest.h>

namespace {

using State = PanelStates::State;

/// Rectangles that only touch do not overlap; positions are rounded.
constexpr float touching = 0.01f;

PanelStates all(State state) {
    PanelStates states;
    states.of.fill(state);
    return states;
}

PanelStates columnsOnly() {
    PanelStates states = all(State::open);
    for (std::size_t i = 0; i < panelCount; ++i)
        if (dockOf(Panel(i)) == Dock::bottom) states.of[i] = State::closed;
    return states;
}

bool overlap(const PanelPlace& a, const PanelPlace& b) {
    return a.position.x < b.position.x + b.size.x - touching &&
           b.position.x < a.position.x + a.size.x - touching &&
           a.position.y < b.position.y + b.size.y - touching &&
           b.position.y < a.position.y + a.size.y - touching;
}

float areaOf(const PanelPlace& place) {
    return place.size.x * place.size.y;
}

/// All rectangles of a layout.
std::vector<PanelPlace> placesOf(const Layout& layout, const PanelStates& states) {
    std::vector<PanelPlace> places{layout.picture};
    for (const Splitter& splitter : layout.splitters) places.push_back(splitter.place);
    for (std::size_t i = 0; i < panelCount; ++i)
        if (states.of[i] != State::closed) places.push_back(layout.panels[i]);
    return places;
}

/// Together they are as large as the window under the menu bar, none covers another, and none is outside.
void expectTiles(const PanelSpace& space, const PanelStates& states, const DockSizes& sizes = {}) {
    const std::vector<PanelPlace> places = placesOf(layoutOf(space, states, sizes), states);
    float sum = 0.0f;
    for (std::size_t i = 0; i < places.size(); ++i) {
        sum += areaOf(places[i]);
        EXPECT_GE(places[i].position.x, -touching);
        EXPECT_GE(places[i].position.y, space.menuHeight - touching);
        EXPECT_LE(places[i].position.x + places[i].size.x, space.display.x + touching);
        EXPECT_LE(places[i].position.y + places[i].size.y, space.display.y + touching);
        for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(places[i], places[k])) << i << " and " << k;
    }
    const float whole = space.display.x * (space.display.y - space.menuHeight);
    // Rounding of sums in single precision.
    EXPECT_NEAR(sum, whole, 1.0e-4f * whole);
}

TEST(Layout, TilesTheWindow) {
    for (const glm::vec2& display :
         {glm::vec2(1280.0f, 720.0f), glm::vec2(3840.0f, 2160.0f), glm::vec2(640.0f, 480.0f)}) {
        expectTiles({display}, all(State::open));
        expectTiles({display}, columnsOnly());
        expectTiles({display}, all(State::closed));
        PanelStates some = columnsOnly();
        some.of[0] = State::collapsed;
        expectTiles({display, 38.0f, 38.0f, 28.0f}, some);
    }
}

TEST(Layout, LeavesMoreThanHalfOfTheWindowToThePicture) {
    const PanelSpace space;
    const Layout layout = layoutOf(space, columnsOnly(), {});
    EXPECT_GT(areaOf(layout.picture), 0.55f * space.display.x * space.display.y);
}

TEST(Layout, ADockWithoutPanelsTakesNoRoom) {
    PanelStates states = columnsOnly();
    for (const Panel panel : {Panel::scene, Panel::materials, Panel::lights})
        states.of[static_cast<std::size_t>(panel)] = State::closed;
    EXPECT_EQ(layoutOf({}, states, {}).picture.position.x, 0.0f);
}

TEST(Layout, ACollapsedPanelLeavesItsRoomToTheOthers) {
    PanelStates states = columnsOnly();
    const float before = layoutOf({}, states, {}).panels[1].size.y;
    states.of[0] = State::collapsed;
    const Layout layout = layoutOf({}, states, {});
    EXPECT_EQ(layout.panels[0].size.y, PanelSpace{}.titleHeight);
    EXPECT_GT(layout.panels[1].size.y, before);
}

TEST(Layout, SplittersMoveWhatIsBesideThem) {
    const PanelSpace space;
    DockSizes sizes;
    const Layout before = layoutOf(space, all(State::open), sizes);
    for (const Splitter& splitter : before.splitters)
        moveSplitter(splitter, {12.0f, 12.0f}, before, space, sizes);
    expectTiles(space, all(State::open), sizes);
    const Layout after = layoutOf(space, all(State::open), sizes);
    ASSERT_EQ(after.splitters.size(), before.splitters.size());
    // The left column is wider, the right one narrower and the strip lower by these 12 units.
    EXPECT_NEAR(after.panels[0].size.x, before.panels[0].size.x + 12.0f, touching);
    EXPECT_NEAR(after.panels[3].size.x, before.panels[3].size.x - 12.0f, touching);
    EXPECT_NEAR(after.picture.size.y, before.picture.size.y + 12.0f, touching);
    EXPECT_GT(after.panels[0].size.y, before.panels[0].size.y);
}

TEST(Layout, NoSplitterTakesAllOfTheWindow) {
    const PanelSpace space;
    for (const float far : {-1.0e5f, 1.0e5f}) {
        DockSizes sizes;
        const Layout layout = layoutOf(space, all(State::open), sizes);
        for (const Splitter& splitter : layout.splitters)
            moveSplitter(splitter, {far, far}, layout, space, sizes);
        const Layout moved = layoutOf(space, all(State::open), sizes);
        for (const PanelPlace& place : placesOf(moved, all(State::open))) EXPECT_GT(areaOf(place), 1.0f);
        EXPECT_GT(areaOf(moved.picture), 0.25f * space.display.x * space.display.y);
    }
}

}  // namespace
