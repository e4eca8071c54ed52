// The order of draws: their records, and the groups of those that share a pipeline key.

#include "render/gpu_scene/draw_list.h"

#include <algorithm>
#include <tuple>

namespace candela {

/// All draws with their numbers, in the order of their records. Few have been added or removed since the last
/// call, as a rule: those that are new are merged into the order of the others.
std::vector<DrawList::Place> DrawList::sortedPlaces(std::span<const std::uint32_t> instances) {
    constexpr std::uint32_t none = 0xffffffffu;
    std::vector<std::uint32_t> numbers(draws_.size(), none);
    std::uint32_t count = 0;
    for (const std::uint32_t instance : instances) {
        const DrawSpan span = instance < spans_.size() ? spans_[instance] : DrawSpan{};
        for (std::uint32_t i = 0; i < span.count; ++i) numbers[span.first + i] = count++;
    }
    const auto isBefore = [&](const Place& a, const Place& b) {
        const auto key = [&](const Place& place) {
            const Draw& draw = draws_[place.draw];
            return std::tuple(draw.geometry, draw.meshOrder, draw.indexInMesh, draw.material, place.number);
        };
        return key(a) < key(b);
    };
    std::vector<Place> places;
    places.reserve(count);
    for (const std::uint32_t draw : drawOfRecord_) {
        if (draws_[draw].placed && numbers[draw] != none) places.push_back({draw, numbers[draw]});
    }
    const auto middle = static_cast<std::ptrdiff_t>(places.size());
    for (std::uint32_t draw = 0; draw < draws_.size(); ++draw) {
        if (numbers[draw] != none && !draws_[draw].placed) places.push_back({draw, numbers[draw]});
    }
    std::sort(places.begin() + middle, places.end(), isBefore);
    // Surfaces of cages may have become others.
    if (!std::is_sorted(places.begin(), places.begin() + middle, isBefore))
        std::sort(places.begin(), places.begin() + middle, isBefore);
    std::inplace_merge(places.begin(), places.begin() + middle, places.end(), isBefore);
    return places;
}

void DrawList::placeRecords(std::span<const std::uint32_t> instances) {
    const std::vector<Place> places = sortedPlaces(instances);
    std::vector<std::array<std::uint32_t, 3>> records;
    records.reserve(places.size());
    numberOfRecord_.clear();
    drawOfRecord_.clear();
    for (const Place& place : places) {
        Draw& draw = draws_[place.draw];
        draw.command.baseInstance = static_cast<std::uint32_t>(records.size());
        draw.placed = true;
        records.push_back({draw.instance, draw.material, place.number});
        numberOfRecord_.push_back(place.number);
        drawOfRecord_.push_back(place.draw);
    }
    recordBuffer_.upload(std::span<const std::array<std::uint32_t, 3>>(records));
    sortGroups();
    unplaced_ = false;
}

/// Takes out what has been removed, and brings the others into the order of their records.
void DrawList::sortGroups() {
    for (auto& [key, group] : groups_) {
        if (group.changed)
            std::erase_if(group.draws,
                          [&, current = &group](std::uint32_t i) { return draws_[i].group != current; });
        const auto recordOf = [&](std::uint32_t i) { return draws_[i].command.baseInstance; };
        if (!std::ranges::is_sorted(group.draws, {}, recordOf)) std::ranges::sort(group.draws, {}, recordOf);
    }
}

std::size_t DrawList::group() {
    if (pending_.empty() && !hasRemoved_) return 0;
    hasRemoved_ = false;
    Groups::iterator last = groups_.end();
    for (const std::uint32_t index : pending_) {
        Draw& draw = draws_[index];
        draw.pending = false;
        if (draw.removed) continue;
        const PipelineKey key = keyOf(draw);
        if (last == groups_.end() || last->first != key) last = groups_.try_emplace(key).first;
        Group& target = last->second;
        if (draw.group == &target) continue;
        if (draw.group != nullptr) draw.group->changed = true;
        draw.group = &target;
        target.changed = true;
        target.added.push_back(index);
    }
    for (auto& [key, group] : groups_) {
        if (!group.changed) continue;
        group.changed = false;
        std::erase_if(group.draws,
                      [&, current = &group](std::uint32_t i) { return draws_[i].group != current; });
        const auto recordOf = [&](std::uint32_t i) { return draws_[i].command.baseInstance; };
        std::ranges::sort(group.added, {}, recordOf);
        const auto middle = static_cast<std::ptrdiff_t>(group.draws.size());
        group.draws.insert(group.draws.end(), group.added.begin(), group.added.end());
        std::ranges::inplace_merge(group.draws, group.draws.begin() + middle, {}, recordOf);
        group.added.clear();
    }
    std::erase_if(groups_, [](const auto& entry) { return entry.second.draws.empty(); });
    const std::size_t count = pending_.size();
    pending_.clear();
    return count;
}

}  // namespace candela
