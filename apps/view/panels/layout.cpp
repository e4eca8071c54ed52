#include "panels/layout.h"

#include <algorithm>

namespace {

/// A column is as wide as its texts need, but leaves room for the picture.
constexpr float columnLetters = 22.0f;
constexpr float widestColumn = 0.28f;
/// Heights as shares of what is under the menu bar, widths of what is between the columns.
constexpr float stripHeight = 0.27f;
constexpr float statisticsWidth = 0.62f;

struct Span {
    float from, to;  ///< Shares of the height.
};

float columnWidth(const PanelSpace& space) {
    return std::min(columnLetters * space.letter, widestColumn * space.display.x);
}

enum class Column { left, right };

PanelPlace inColumn(const PanelSpace& space, Column column, const Span& span) {
    const float width = columnWidth(space);
    const float height = space.display.y - space.menuHeight;
    const float x = column == Column::left ? 0.0f : space.display.x - width;
    return {{x, space.menuHeight + span.from * height}, {width, (span.to - span.from) * height}};
}

PanelPlace inStrip(const PanelSpace& space, const Span& span) {
    const float column = columnWidth(space);
    const float width = space.display.x - 2.0f * column;
    const float height = stripHeight * (space.display.y - space.menuHeight);
    return {{column + span.from * width, space.display.y - height}, {(span.to - span.from) * width, height}};
}

}  // namespace

PanelPlace firstPlace(Panel panel, const PanelSpace& space) {
    switch (panel) {
        case Panel::scene:
            return inColumn(space, Column::left, {0.0f, 0.27f});
        case Panel::materials:
            return inColumn(space, Column::left, {0.27f, 0.56f});
        case Panel::lights:
            return inColumn(space, Column::left, {0.56f, 1.0f});
        case Panel::camera:
            return inColumn(space, Column::right, {0.0f, 0.29f});
        case Panel::color:
            return inColumn(space, Column::right, {0.29f, 0.6f});
        case Panel::drawing:
            return inColumn(space, Column::right, {0.6f, 1.0f});
        case Panel::statistics:
            return inStrip(space, {0.0f, statisticsWidth});
        case Panel::probe:
            return inStrip(space, {statisticsWidth, 1.0f});
    }
    return {};
}

PanelPlace freePicture(const PanelSpace& space) {
    const float column = columnWidth(space);
    const float height = (1.0f - stripHeight) * (space.display.y - space.menuHeight);
    return {{column, space.menuHeight}, {space.display.x - 2.0f * column, height}};
}
