#pragma once

#include "common/shadow_stats.h"
#include "frame_writer.h"
#include "run_report.h"
#include "scene_contents.h"

#include <candela/renderer.h>

#include <cstdint>
#include <string>
#include <vector>

/// The contents of --stats.
struct Stats {
    std::string file;              ///< The scene's name on the command line.
    std::string renderer, driver;  ///< GL_RENDERER; GL_VENDOR and GL_VERSION.
    std::string device;            ///< Such as "EGL device 0 (/dev/dri/renderD128)".
    int width = 0, height = 0;
    candela::Technique technique = candela::Technique::automatic;
    candela::BrdfModel brdf = candela::BrdfModel::course;
    std::uint64_t triangles = 0, materials = 0, lights = 0, lines = 0, points = 0;
    unsigned threads = 0;                 ///< That parallel work used.
    std::string environment;              ///< "studio", "sky", "scene" or a file; empty without one.
    std::string tileBackend;              ///< "cpu" or "compute"; empty where another technique ran.
    std::string vertexEvaluator;          ///< "cpu" or "compute"; empty without refined cages.
    std::vector<FrameTiming> timings;     ///< None where no picture was drawn.
    std::vector<PictureResult> pictures;  ///< Those that were written.
    candela::PairCounts pairs;            ///< Of the last frame.
    std::uint32_t samples = 1;            ///< Of each picture.
    std::vector<ContentCount> contents, materialKinds;  ///< Of the scene; see scene_contents.h.
    std::vector<candela::ImportNote> notes;             ///< What of its file is drawn otherwise, or not.
    std::optional<ShadowStats> shadows;                 ///< Of the last frame; none without shadows.
};

/// The JSON text of `stats`, with a newline at its end. Keys and their order are a contract with other
/// programs; new ones are appended.
std::string statsJson(const Stats& stats);
