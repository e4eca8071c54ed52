#pragma once

#include "view_model.h"

/// The tab in which lights are strewn over the scene.
void drawLightStrewing(ViewModel& model);

/// The tab in which lights are set moving.
void drawLightMotion(ViewModel& model);
