#pragma once

/// Everything candela offers.

#include <candela/animation.h>
#include <candela/accumulator.h>
#include <candela/brdf.h>
#include <candela/cage.h>
#include <candela/camera.h>
#include <candela/color.h>
#include <candela/context.h>
#include <candela/default_lights.h>
#include <candela/deformation.h>
#include <candela/environment.h>
#include <candela/error.h>
#include <candela/exposure.h>
#include <candela/frame_data.h>
#include <candela/frame_settings.h>
#include <candela/gbuffer.h>
#include <candela/gpu_scene.h>
#include <candela/image.h>
#include <candela/image_file.h>
#include <candela/import.h>
#include <candela/light.h>
#include <candela/material.h>
#include <candela/mesh.h>
#include <candela/node.h>
#include <candela/plugin.h>
#include <candela/plugin_registry.h>
#include <candela/refined_cage.h>
#include <candela/renderer.h>
#include <candela/sampling.h>
#include <candela/scene.h>
#include <candela/subdivider.h>
#include <candela/threads.h>
#include <candela/version.h>
#include <candela/whole_file.h>
