#pragma once

#include "scene/model/property_animation.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace candela {

/// The animated elements of one type of a scene on the device, and the channels that change them. The scene
/// has to outlive the object.
template <typename Element>
class PropertyTracks {
  public:
    /// The elements of the scene are at rest.
    explicit PropertyTracks(const Scene& scene) : scene_(scene) {
        std::map<std::uint32_t, Track> tracks;
        for (const Animation& animation : scene.animations) {
            for (const PropertyChannel& channel : animation.properties) {
                if (elementOf(channel.property) != kindOf<Element>) continue;
                const Element& rest = elementsOf<Element>(scene)[channel.element];
                tracks.try_emplace(channel.element, Track{channel.element, rest, {}, {}});
            }
        }
        for (auto& [index, track] : tracks) tracks_.push_back(std::move(track));
        select();
    }

    /// To be called when other animations of the scene play.
    void select() {
        for (Track& track : tracks_) {
            track.channels.clear();
            track.isStale = true;
        }
        for (const Animation& animation : scene_.animations) {
            if (!animation.plays) continue;
            for (const PropertyChannel& channel : animation.properties) {
                if (elementOf(channel.property) != kindOf<Element>) continue;
                const auto track = std::ranges::lower_bound(tracks_, channel.element, {}, &Track::index);
                if (track != tracks_.end() && track->index == channel.element)
                    track->channels.push_back(&channel);
            }
        }
    }

    /// Does the scene's frame callback still change an element?
    bool takes(std::uint32_t index) const { return !isCleared_ && !removed_.contains(index); }
    /// The channels of the scene's frame callback at the time of the next `pose`, which change elements after
    /// those of animations. Kept until the next call.
    void setGiven(const std::vector<PropertyChannel>& channels) {
        for (Track& track : tracks_) {
            track.isStale = track.isStale || !track.given.empty();
            track.given.clear();
        }
        for (const PropertyChannel& channel : channels) {
            if (elementOf(channel.property) != kindOf<Element> || !takes(channel.element)) continue;
            Track& track = trackOf(channel.element);
            track.given.push_back(&channel);
            track.isStale = true;
        }
    }

    /// Ends the animation of all elements.
    void clear() {
        tracks_.clear();
        isCleared_ = true;
    }
    /// The same of one.
    void remove(std::uint32_t index) {
        std::erase_if(tracks_, [&](const Track& track) { return track.index == index; });
        if (scene_.frameCallback) removed_.insert(index);
    }

    /// Calls `change(index, element)` with each element as of `time` that is another one than at the last
    /// call. The element depends on the time alone, and not on earlier calls.
    template <typename Change>
    void pose(double time, const Change& change) {
        for (Track& track : tracks_) {
            values_.clear();
            for (const PropertyChannel* channel : track.channels)
                values_.push_back(sampleProperty(*channel, time));
            if (!track.isStale && values_ == track.values) continue;
            Element element = track.rest;
            for (std::size_t i = 0; i < values_.size(); ++i)
                setProperty(*track.channels[i], values_[i], element);
            for (const PropertyChannel* channel : track.given)
                setProperty(*channel, sampleProperty(*channel, time), element);
            settle(element);
            change(track.index, element);
            track.values = values_;
            track.isStale = false;
        }
    }

  private:
    struct Track {
        std::uint32_t index;
        Element rest;
        std::vector<const PropertyChannel*> channels;  ///< Those that play; the later ones apply.
        std::vector<glm::vec4> values;                 ///< Of these, as of the last `pose`.
        bool isStale = true;
        std::vector<const PropertyChannel*> given = {};  ///< Of the frame callback.
    };

    /// An element that no animation changes is at rest when it gets its track.
    Track& trackOf(std::uint32_t index) {
        const auto track = std::ranges::lower_bound(tracks_, index, {}, &Track::index);
        if (track != tracks_.end() && track->index == index) return *track;
        return *tracks_.insert(track, Track{index, elementsOf<Element>(scene_)[index], {}, {}});
    }

    const Scene& scene_;
    std::vector<Track> tracks_;  ///< In ascending order of index.
    std::vector<glm::vec4> values_;
    std::set<std::uint32_t> removed_;  ///< Elements that the frame callback does not change any more.
    bool isCleared_ = false;
};

}  // namespace candela
