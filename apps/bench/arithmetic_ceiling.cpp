#include "arithmetic_ceiling.h"

#include "common/gl_program.h"
#include "common/timing.h"
#include "measure.h"
#include "shading_source.h"

#include <candela/error.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace {

constexpr const char* before = R"(#version 450 core
#define Real float
#define Real3 vec3
#define Scalar float
#define SHARED_FUNCTION
#define AlbedoTable int
float fastDivide(float a, float b) { return a / b; }
)";

// The light moves from one iteration to the next, so that nothing of the equation is the same in all of them:
// three additions that are not part of it.
constexpr const char* after = R"(
AlbedoTexel readAlbedoTable(int table, float x, float y) { return AlbedoTexel(0.9, 0.5); }
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer Sums { vec4 sums[64]; };
layout(location = 0) uniform int lights;
void main() {
    float place = fract(float(gl_GlobalInvocationID.x) * 0.618034);
    SurfaceLobes lobes = SurfaceLobes(vec3(0.5, 0.4, place), 0.0, 0.2 + 0.7 * place);
    ShadingPoint point = shadingPoint(BRDF, lobes, vec3(0.0, 1.0, 0.0), vec3(place, 0.0, 0.0), vec3(0.2, 0.6, 0.7), 0);
    LocalLight light = LocalLight(vec3(0.3, 1.0, 0.5), 1.0 / 81.0, vec3(1.0, 0.5, 0.3));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lights; ++i) {
        light.position += vec3(1.0e-3, 2.0e-3, -1.0e-3);
        sum += pointLightRadiance(BRDF, point, light);
    }
    sums[gl_LocalInvocationIndex] = vec4(sum, 0.0);
}
)";

constexpr int invocationsPerGroup = 64;
/// Of an invocation: fewer than a software rasteriser ends a loop after, and the light stays in range.
constexpr int lightsPerInvocation = 1024;
/// Every device takes so many in one dispatch.
constexpr int maxGroups = 65535;
constexpr double minMilliseconds = 25.0;
constexpr int runs = 7;

class CeilingProgram {
  public:
    CeilingProgram(const candela::Context& context, candela::BrdfModel model)
        : clock_(context), program_(makeComputeProgram(before + definition(model) + shadingSource + after)) {
        glCreateBuffers(1, &sums_);
        glNamedBufferStorage(sums_, invocationsPerGroup * 4 * sizeof(float), nullptr, 0);
    }
    CeilingProgram(const CeilingProgram&) = delete;
    CeilingProgram& operator=(const CeilingProgram&) = delete;
    ~CeilingProgram() {
        glDeleteBuffers(1, &sums_);
        glDeleteProgram(program_);
    }

    double milliseconds(int groups) {
        glUseProgram(program_);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, sums_);
        glUniform1i(0, lightsPerInvocation);
        clock_.start();
        glDispatchCompute(static_cast<GLuint>(groups), 1, 1);
        clock_.lap("pairs");
        return clock_.times().frame;
    }

  private:
    static std::string definition(candela::BrdfModel model) {
        return std::string("#define BRDF ") +
               (model == candela::BrdfModel::gltf ? "BRDF_GLTF" : "BRDF_COURSE") + "\n";
    }

    PassClock clock_;
    GLuint program_, sums_ = 0;
};

double measurePairs(const candela::Context& context, candela::BrdfModel model) {
    CeilingProgram program(context, model);
    int groups = 16;
    program.milliseconds(groups);  // Compiles.
    while (groups < maxGroups && program.milliseconds(groups) < minMilliseconds)
        groups = std::min(2 * groups, maxGroups);
    std::vector<double> times;
    for (int run = 0; run < runs; ++run) times.push_back(program.milliseconds(groups));
    const double pairs = static_cast<double>(groups) * invocationsPerGroup * lightsPerInvocation;
    return pairs / std::max(median(times), 1.0e-6) * 1000.0;
}

}  // namespace

Ceiling measureCeiling(const candela::Context& context, candela::BrdfModel model) {
    Ceiling ceiling;
    try {
        ceiling.pairsPerSecond = measurePairs(context, model);
    } catch (const candela::Error& error) {
        ceiling.error = error.what();
    }
    return ceiling;
}

std::string ceilingText(const Ceiling& ceiling) {
    if (ceiling.error) return "ceiling: not measured: " + *ceiling.error + "\n";
    const auto millions = static_cast<std::uint64_t>(ceiling.pairsPerSecond * 1.0e-6);
    return "ceiling: compute shaders shade at most " + std::to_string(millions) +
           " M pairs a second, with everything in registers\n";
}
