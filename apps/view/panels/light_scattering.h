#pragma once

#include "view_model.h"

/// The tab in which lights are scattered over the scene.
void drawLightScattering(ViewModel& model);

/// The tab in which lights are set moving.
void drawLightMotion(ViewModel& model);
