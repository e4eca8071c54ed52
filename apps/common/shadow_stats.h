#pragma once

#include <candela/gpu_scene.h>
#include <candela/renderer.h>

#include <nlohmann/json.hpp>

#include <optional>

/// `on` or `off`: what a frame is drawn with.
inline candela::Shadows drawnShadows(candela::Shadows shadows) {
    if (shadows != candela::Shadows::automatic) return shadows;
    return candela::hasShadows() ? candela::Shadows::on : candela::Shadows::off;
}

/// The occlusion rays of a frame, and what they are traced in.
struct ShadowStats {
    candela::ShadowCounts rays;
    candela::OcclusionReport structure;
};

/// Of a frame that was drawn last; none where it was drawn without shadows.
inline std::optional<ShadowStats> shadowStats(const candela::Frame& frame, const candela::GpuScene& scene,
                                              candela::Shadows shadows) {
    if (drawnShadows(shadows) == candela::Shadows::off) return std::nullopt;
    return ShadowStats{frame.shadowCounts(), scene.occlusionReport()};
}

/// As --stats and candela-bench write it. Keys and their order are a contract with other programs.
inline nlohmann::ordered_json shadowJson(const ShadowStats& stats) {
    return {{"rays_asked", stats.rays.raysAsked},
            {"rays_traced", stats.rays.raysTraced},
            {"rays_saved", stats.rays.raysSaved},
            {"triangles", stats.structure.triangles},
            {"instances", stats.structure.instances},
            {"bytes", stats.structure.bytes},
            {"build_ms", stats.structure.buildMilliseconds},
            {"update_ms", stats.structure.updateMilliseconds}};
}
