#include "render/environment/gpu_environment.h"

#include "scene/validate/scene_rules.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace candela {

namespace {

gl::Texture uploaded(const Image& picture) {
    const auto width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
    gl::Texture texture = gl::Texture::target2d(GL_RGBA32F, width, height, "environment picture");
    glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, picture.pixels.data());
    return texture;
}

EnvironmentView viewOf(const EnvironmentMap& map) {
    static_assert(EnvironmentView::levelCount == EnvironmentMap::levelCount);
    EnvironmentView view{};
    view.texels = map.texels().data();
    for (int i = 0; i < EnvironmentMap::levelCount; ++i) {
        view.firstTexels[i] = static_cast<float>(map.level(i).first);
        view.sizes[i] = static_cast<float>(map.level(i).size);
    }
    view.irradianceFirst = static_cast<float>(map.irradiance().first);
    view.irradianceSize = static_cast<float>(map.irradiance().size);
    view.peaks = map.texels().data() + 4 * layout::ENVIRONMENT_PEAKS;
    view.peakCount = static_cast<int>(map.peaks().size());
    return view;
}

}  // namespace

GpuEnvironment::GpuEnvironment(const Environment& environment, const glm::dmat3& workingFromRec709)
    : largestRadiance_(candela::largestRadiance(environment.picture)),
      map_(environment.picture, workingFromRec709),
      view_(viewOf(map_)),
      picture_(uploaded(environment.picture)) {
    set({environment.rotation, environment.intensity, environment.isBackground,
         environment.occlusionDistance});
}

void GpuEnvironment::set(const EnvironmentSettings& settings) {
    settings_ = settings;
    // The columns of the matrix are the rows of its inverse.
    const glm::mat3 worldFromPicture = glm::mat3_cast(glm::normalize(settings.rotation));
    for (int row = 0; row < 3; ++row) {
        for (int i = 0; i < 3; ++i) view_.axes[row][i] = worldFromPicture[row][i];
    }
    view_.intensity = settings.intensity;
}

void GpuEnvironment::describe(layout::FrameUniforms& uniforms) const {
    const auto row = [&](int i, float w) {
        return glm::vec4(view_.axes[i][0], view_.axes[i][1], view_.axes[i][2], w);
    };
    uniforms.environmentX = row(0, view_.intensity);
    uniforms.environmentY = row(1, 0.0f);
    uniforms.environmentZ = row(2, 0.0f);
}

void GpuEnvironment::bindMaps() const {
    if (!texels_) {
        texels_.emplace(GL_RGBA32F, "environment maps");
        texels_->upload(map_.texels());
    }
    glBindTextureUnit(layout::ENVIRONMENT_UNIT, texels_->name());
}

}  // namespace candela
