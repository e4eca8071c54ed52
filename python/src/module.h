#pragma once

#include <nanobind/nanobind.h>

/// What each file of the module binds, in the order in which the classes refer to each other.
namespace candela::python {

void bindErrors(nanobind::module_& module);
void bindMaterials(nanobind::module_& module);
void bindMeshes(nanobind::module_& module);
void bindNodes(nanobind::module_& module);
void bindAnimations(nanobind::module_& module);
void bindCameraViews(nanobind::module_& module);
void bindEnvironments(nanobind::module_& module);
void bindScenes(nanobind::module_& module);
void bindColor(nanobind::module_& module);
void bindContexts(nanobind::module_& module);
void bindSettings(nanobind::module_& module);
void bindGpuScenes(nanobind::module_& module);
void bindFrames(nanobind::module_& module);
void bindRenderers(nanobind::module_& module);
void bindImageFiles(nanobind::module_& module);
void bindMachine(nanobind::module_& module);

}  // namespace candela::python
