#pragma once

#include "render/subdivision/limit_streams.h"

#include <glm/vec3.hpp>

#include <vector>

namespace candela {

/// Evaluates limit surfaces in threads, straight into mapped buffers.
class CpuEvaluator {
  public:
    void evaluate(const LimitRequest& request);

  private:
    void writeTangents(const LimitRequest& request, std::span<const glm::vec3> normals);

    std::vector<glm::vec3> du_, dv_;
};

}  // namespace candela
