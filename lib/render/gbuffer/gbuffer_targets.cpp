#include "render/gbuffer/gbuffer_targets.h"

namespace candela {

GBufferTargets::GBufferTargets(int pixelsWide, int pixelsHigh)
    : width(pixelsWide),
      height(pixelsHigh),
      surface(gl::Texture::target2d(GL_RG32UI, width, height, "G-buffer surface")),
      depth(gl::Texture::target2d(GL_DEPTH_COMPONENT32F, width, height, "G-buffer depth")),
      radiance(gl::Texture::target2d(GL_RGBA32F, width, height, "radiance")),
      surfaces({&surface}, &depth, "G-buffer"),
      surfacesAndEmission({&surface, &radiance}, &depth, "G-buffer with emission"),
      lit({&radiance}, nullptr, "radiance") {}

}  // namespace candela
