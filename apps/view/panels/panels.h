#pragma once

#include "panels/panel.h"
#include "view_model.h"

/// Each draws one panel with Dear ImGui, reads and changes the model, and asks for the rest by
/// `ViewModel::requests`. To be called between ImGui::NewFrame and ImGui::Render.
void drawMenuBar(ViewModel& model);
void drawScenePanel(ViewModel& model);       ///< Tree of nodes with visibility; picking.
void drawMaterialPanel(ViewModel& model);    ///< Colour, metal and roughness of the picked material.
void drawLightPanel(ViewModel& model);       ///< List, picked light, scattering, motion.
void drawCameraPanel(ViewModel& model);      ///< Cameras of the file, eye, target, field of view.
void drawColorPanel(ViewModel& model);       ///< Config, display, view, look, exposure.
void drawDrawingPanel(ViewModel& model);     ///< Technique, reflection model, what is shown, subdivision.
void drawStatisticsPanel(ViewModel& model);  ///< Passes as a running graph, counters.
void drawTimelinePanel(ViewModel& model);    ///< Time, and the animations that play.
void drawProbePanel(ViewModel& model);       ///< The pixel under the pointer.
void drawHeatLegend(
    const ViewModel& model);  ///< Over the picture, for the views of light counts and `DebugView::level`.
void drawStartPage(ViewModel& model);  ///< What can be opened, while nothing is.
void drawHelp(ViewModel& model);       ///< The keys, and what this program is, while they are asked for.
void drawHiddenHint(const ViewModel& model);  ///< How hidden panels come back.
void drawLoading(ViewModel& model);           ///< Progress bar with a button that cancels.
void drawMessages(ViewModel& model);          ///< Notes and errors until dismissed; the shader error.

/// Draws all panels that are open.
void drawPanels(ViewModel& model);
