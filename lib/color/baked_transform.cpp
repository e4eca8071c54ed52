#include "color/baked_transform.h"

#include "color/aces_steps.h"
#include "color/display_transform.h"
#include "color/ocio.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace candela {

namespace {

using Group = std::vector<OCIO::ConstTransformRcPtr>;

Group stepsOf(const OCIO::ConstProcessorRcPtr& processor) {
    const auto all = processor->getOptimizedProcessor(ocioPrecision)->createGroupTransform();
    Group steps;
    for (int i = 0; i < all->getNumTransforms(); ++i) steps.push_back(all->getTransform(i));
    return steps;
}

OCIO::ConstProcessorRcPtr processorOf(std::span<const OCIO::ConstTransformRcPtr> steps) {
    const auto group = OCIO::GroupTransform::Create();
    for (const auto& step : steps) group->appendTransform(step->createEditableCopy());
    return OCIO::Config::CreateRaw()->getProcessor(group);
}

void applyTo(const OCIO::ConstCPUProcessorRcPtr& cpu, std::span<float> rgba) {
    OCIO::PackedImageDesc image(rgba.data(), long(rgba.size() / 4), 1, 4);
    cpu->apply(image);
}

bool isMatrixOrRange(const OCIO::ConstTransformRcPtr& step) {
    const OCIO::TransformType type = step->getTransformType();
    return type == OCIO::TRANSFORM_TYPE_MATRIX || type == OCIO::TRANSFORM_TYPE_RANGE;
}

/// Whether each channel of the step's result depends on that channel only. Tested on colours, so that it
/// works for every kind of step.
bool isPerChannel(const OCIO::ConstTransformRcPtr& step) {
    const auto cpu = processorOf({&step, 1})->getOptimizedCPUProcessor(ocioPrecision);
    std::uint32_t state = 1;
    const auto next = [&state] {
        state = state * 1664525u + 1013904223u;
        const float size = std::exp2(-12.0f + 24.0f * float(state >> 8) / float(1 << 24));
        return (state & 128) != 0 ? size : -0.25f * size;
    };
    for (int i = 0; i < 256; ++i) {
        const float red = next(), green = next(), blue = next();
        std::vector<float> pixels{red,   green, blue,  1, red,  red,  red,  1,
                                  green, green, green, 1, blue, blue, blue, 1};
        applyTo(cpu, pixels);
        for (std::size_t c = 0; c < 3; ++c) {
            const float together = pixels[c], alone = pixels[4 * (c + 1) + c];
            if (together == alone) continue;  // Infinity too.
            if (!(std::abs(together - alone) <= 1e-6f * std::max(1.0f, std::abs(alone)))) return false;
        }
    }
    return true;
}

CurveTable tableOf(const OCIO::ConstCPUProcessorRcPtr& cpu) {
    return CurveTable([&](std::span<CurveTable::Values> numbers) {
        std::vector<float> pixels;
        for (const auto& [red, green, blue] : numbers) pixels.insert(pixels.end(), {red, green, blue, 1.0f});
        applyTo(cpu, pixels);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = {pixels[4 * i], pixels[4 * i + 1], pixels[4 * i + 2]};
    });
}

/// Colours on which a baked transform is tested: every channel from -16 to 65504 with every other, more
/// densely in the range that pictures have.
std::vector<float> testColors() {
    std::vector<float> levels{-16.0f, -0.25f, -0.001f, 0.0f, 1e-6f, 1e-4f, 64.0f, 1000.0f, maxRadiance};
    for (int i = 0; i < 15; ++i) levels.push_back(std::exp2(-10.0f + float(i)));
    std::vector<float> colors;
    for (const float red : levels)
        for (const float green : levels)
            for (const float blue : levels) colors.insert(colors.end(), {red, green, blue, 1.0f});
    return colors;
}

/// The step of a matrix, if it is one: alpha is 1.
std::optional<DisplayStep> matrixStep(const OCIO::ConstTransformRcPtr& transform) {
    const auto matrix = OCIO_DYNAMIC_POINTER_CAST<const OCIO::MatrixTransform>(transform);
    if (!matrix || matrix->getDirection() != OCIO::TRANSFORM_DIR_FORWARD) return {};
    double rows[16], offset[4];
    matrix->getMatrix(rows);
    matrix->getOffset(offset);
    DisplayStep step{.kind = DisplayStep::Kind::matrix};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            step.matrix[row][column] = float(rows[4 * row + column]);
        step.matrix[row][3] = float(rows[4 * row + 3] + offset[row]);
    }
    return step;
}

/// The step of a range that clamps, if it is one.
std::optional<DisplayStep> clampStep(const OCIO::ConstTransformRcPtr& transform) {
    const auto range = OCIO_DYNAMIC_POINTER_CAST<const OCIO::RangeTransform>(transform);
    if (!range || range->getStyle() != OCIO::RANGE_CLAMP) return {};
    const bool hasMin = range->hasMinInValue(), hasMax = range->hasMaxInValue();
    if (hasMin != range->hasMinOutValue() || hasMax != range->hasMaxOutValue()) return {};
    if (hasMin && range->getMinInValue() != range->getMinOutValue()) return {};
    if (hasMax && range->getMaxInValue() != range->getMaxOutValue()) return {};
    constexpr float unlimited = std::numeric_limits<float>::max();
    return DisplayStep{.kind = DisplayStep::Kind::clamp,
                       .low = hasMin ? float(range->getMinInValue()) : -unlimited,
                       .high = hasMax ? float(range->getMaxInValue()) : unlimited};
}

void applyPlanes(const void* processor, float* red, float* green, float* blue, std::size_t count) {
    std::vector<float> alpha(count, 1.0f);
    OCIO::PlanarImageDesc planes(red, green, blue, alpha.data(), long(count), 1);
    static_cast<const OCIO::CPUProcessor*>(processor)->apply(planes);
}

void addOther(const OCIO::ConstCPUProcessorRcPtr& processor, OwnedDisplaySteps& owned) {
    owned.processors.push_back(processor);
    owned.steps.push_back(
        {.kind = DisplayStep::Kind::other, .processor = processor.get(), .apply = applyPlanes});
}

/// The steps of an exact part: matrices and ranges that clamp are applied as such.
void addExact(const OCIO::ConstProcessorRcPtr& part, OwnedDisplaySteps& owned) {
    const Group all = stepsOf(part);
    for (const OCIO::ConstTransformRcPtr& transform : all) {
        if (const auto matrix = matrixStep(transform)) {
            owned.steps.push_back(*matrix);
            continue;
        }
        if (const auto clamp = clampStep(transform)) {
            owned.steps.push_back(*clamp);
            continue;
        }
        addOther(processorOf({&transform, 1})->getOptimizedCPUProcessor(ocioPrecision), owned);
    }
}

/// The curves of a table: a row serves all channels, or each has its own.
void setCurves(const CurveTable& table, DisplayStep& step, OwnedDisplaySteps& owned) {
    std::vector<float>& values = owned.tables.emplace_back();
    table.appendTo(values);
    const std::size_t next = table.isShared() ? 0 : 2 * std::size_t(CurveTable::rowLength());
    for (std::size_t channel = 0; channel < 3; ++channel)
        step.curves[channel] = values.data() + channel * next;
}

std::string number(std::size_t value) {
    return std::to_string(value);
}

}  // namespace

OwnedDisplaySteps exactStep(const OCIO::ConstCPUProcessorRcPtr& processor) {
    OwnedDisplaySteps owned;
    addOther(processor, owned);
    return owned;
}

std::optional<BakedTransform> BakedTransform::make(const OCIO::ConstProcessorRcPtr& processor,
                                                   std::size_t minCurves) {
    const Group all = stepsOf(processor);
    BakedTransform baked;
    std::size_t curves = 0;
    const auto add = [&](Step::Kind kind, std::size_t first, std::size_t end) {
        if (first == end) return;
        const auto part = processorOf(std::span(all).subspan(first, end - first));
        baked.steps_.push_back({kind, part, part->getOptimizedCPUProcessor(ocioPrecision), {}});
        if (kind == Step::Kind::curves) baked.steps_.back().table = tableOf(baked.steps_.back().cpu);
        if (kind == Step::Kind::darkToDim) baked.steps_.back().table = darkToDimFactor();
    };
    std::size_t exactFrom = 0;
    for (std::size_t i = 0; i < all.size();) {
        std::size_t end = i;
        Step::Kind kind = Step::Kind::exact;
        if (i + 1 < all.size() && isGlowAndRed(all[i], all[i + 1])) {
            kind = Step::Kind::glowAndRed, end = i + 2;
        } else if (isDarkToDim(all[i])) {
            kind = Step::Kind::darkToDim, end = i + 1;
        } else {
            while (end < all.size() && isPerChannel(all[end])) ++end;
            const auto run = std::span(all).subspan(i, end - i);
            const auto costly = run.size() - std::size_t(std::ranges::count_if(run, isMatrixOrRange));
            if (costly > 0) kind = Step::Kind::curves, curves += costly;
        }
        if (kind == Step::Kind::exact) {
            i = std::max(end, i + 1);
            continue;
        }
        add(Step::Kind::exact, exactFrom, i);
        add(kind, i, end);
        exactFrom = i = end;
    }
    add(Step::Kind::exact, exactFrom, all.size());
    if (curves < minCurves) return {};
    if (!baked.steps_.empty() && baked.steps_.back().kind == Step::Kind::curves)
        baked.steps_.back().table->clampToCodes();
    const auto exact = processor->getOptimizedCPUProcessor(ocioPrecision);
    if (!(baked.maxError(exact) <= errorLimit)) return {};
    return baked;
}

void BakedTransform::apply(std::span<float> rgba) const {
    for (const Step& step : steps_) {
        if (step.kind != Step::Kind::curves) {
            applyTo(step.cpu, rgba);
            continue;
        }
        for (std::size_t i = 0; i < rgba.size(); ++i)
            if (i % 4 != 3) rgba[i] = step.table->at(int(i % 4), rgba[i]);
    }
}

float BakedTransform::maxError(const OCIO::ConstCPUProcessorRcPtr& exact) const {
    std::vector<float> expected = testColors(), actual = expected;
    applyTo(exact, expected);
    apply(actual);
    float max = 0.0f;
    for (std::size_t i = 0; i < expected.size(); ++i)
        max = std::max(max, std::abs(sanitizedCode(expected[i]) - sanitizedCode(actual[i])));
    return 255.0f * max;
}

OwnedDisplaySteps BakedTransform::steps() const {
    OwnedDisplaySteps owned;
    owned.tables.reserve(steps_.size());  // Steps refer to what the tables hold.
    for (const Step& step : steps_) {
        if (step.kind == Step::Kind::exact) {
            addExact(step.processor, owned);
            continue;
        }
        const auto kind = step.kind == Step::Kind::glowAndRed  ? DisplayStep::Kind::glowAndRed
                          : step.kind == Step::Kind::darkToDim ? DisplayStep::Kind::darkToDim
                                                               : DisplayStep::Kind::curves;
        owned.steps.push_back({.kind = kind});
        if (step.table) setCurves(*step.table, owned.steps.back(), owned);
    }
    return owned;
}

DisplayShader BakedTransform::shader() const {
    DisplayShader shader;
    std::string functions, calls;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const Step& step = steps_[i];
        if (step.kind == Step::Kind::glowAndRed) {
            functions += glowAndRedGlsl();
            calls += "    color = candelaGlowAndRed(color);\n";
        } else if (step.kind == Step::Kind::darkToDim) {
            functions += darkToDimGlsl();
            calls += "    color = candelaDarkToDim(color, " +
                     std::to_string(step.table->appendTo(shader.curves)) + ");\n";
        } else if (step.kind == Step::Kind::curves) {
            const int first = step.table->appendTo(shader.curves),
                      next = step.table->isShared() ? 0 : CurveTable::rowLength();
            const auto channel = [&](const char* name, int row) {
                return "candelaCurve(" + std::to_string(first + row * next) + ", color." + name + ")";
            };
            calls += "    color = vec3(" + channel("r", 0) + ", " + channel("g", 1) + ", " + channel("b", 2) +
                     ");\n";
        } else {
            const std::string name = "ocioStep" + number(i);
            functions += exactGlsl(step.processor, name, shader.textures);
            calls += "    color = " + name + "(vec4(color, 1.0)).rgb;\n";
        }
    }
    // Codes read from a table are finite and limited.
    const bool endsInTable = steps_.back().kind == Step::Kind::curves;
    shader.glsl = sanitizeGlsl() + CurveTable::glsl() + functions +
                  "\nvec4 displayTransform(vec4 radiance) {\n"
                  "    vec3 color = sanitizedRadiance(radiance.rgb);\n" +
                  calls + "    return vec4(" + (endsInTable ? "color" : "sanitizedCode(color)") +
                  ", radiance.a);\n}\n";
    return shader;
}

}  // namespace candela
