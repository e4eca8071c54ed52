#include "module.h"

NB_MODULE(_candela, module) {
    namespace python = candela::python;
    nanobind::set_leak_warnings(false);  // What is alive when the interpreter ends is no fault.
    module.doc() = "The compiled part of candela; use the package `candela`.";
    python::bindErrors(module);
    python::bindMaterials(module);
    python::bindMeshes(module);
    python::bindNodes(module);
    python::bindAnimations(module);
    python::bindCameraViews(module);
    python::bindEnvironments(module);
    python::bindScenes(module);
    python::bindColor(module);
    python::bindContexts(module);
    python::bindSettings(module);
    python::bindMachine(module);
    python::bindGpuScenes(module);
    python::bindFrames(module);
    python::bindRenderers(module);
    python::bindImageFiles(module);
}
