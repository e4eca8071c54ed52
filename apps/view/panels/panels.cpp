#include "panels/panels.h"

namespace {

void drawOpenPanels(ViewModel& model) {
    if (model.panelsHidden) return;
    if (model.panels.scene) drawScenePanel(model);
    if (model.panels.material) drawMaterialPanel(model);
    if (model.panels.lights) drawLightPanel(model);
    if (model.panels.camera) drawCameraPanel(model);
    if (model.panels.color) drawColorPanel(model);
    if (model.panels.drawing) drawDrawingPanel(model);
    if (model.panels.statistics) drawStatisticsPanel(model);
    if (model.panels.probe) drawProbePanel(model);
    if (model.panels.timeline && hasTimeline(model)) drawTimelinePanel(model);
    drawSplitters(model);
}

}  // namespace

void drawPanels(ViewModel& model) {
    model.thumbnails.camerasShown = model.thumbnails.variantsShown = false;
    sceneNumber(model);  // a panel that is closed while a scene is opened learns of it here
    drawMenuBar(model);
    drawOpenPanels(model);
    drawStartPage(model);
    drawHeatLegend(model);
    drawLoading(model);
    drawMessages(model);
    drawHelp(model);
    drawHiddenHint(model);
}
