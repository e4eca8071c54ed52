#include <candela/subdivider.h>

#include "base/thread_pool.h"
#include "import/abi_reader.h"
#include "import/import_refined_cage.h"
#include "import/plugin_abi.h"
#include "import/plugin_file.h"
#include "import/refinement.h"
#include "scene/validate/scene_rules.h"

#include <candela/error.h>

#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

namespace candela {
namespace {

static_assert(sizeof(glm::vec3) == 3 * sizeof(float) && sizeof(glm::vec2) == 2 * sizeof(float));

template <class T>
std::uint32_t countOf(const std::vector<T>& elements, const char* what, const Cage& cage) {
    if (elements.size() > std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorKind::limit, "",
                    joined(AbiReader("cage", std::nullopt, cage.name.c_str()).label(), ": it has ",
                           elements.size(), " ", what, ", more than 32 bits can count"));
    return static_cast<std::uint32_t>(elements.size());
}

candela_scheme schemeOf(SubdivisionScheme scheme) {
    switch (scheme) {
        case SubdivisionScheme::loop:
            return CANDELA_SCHEME_LOOP;
        case SubdivisionScheme::bilinear:
            return CANDELA_SCHEME_BILINEAR;
        default:
            return CANDELA_SCHEME_CATMULL_CLARK;
    }
}

candela_boundary_interpolation boundaryOf(BoundaryInterpolation boundary) {
    switch (boundary) {
        case BoundaryInterpolation::none:
            return CANDELA_BOUNDARY_NONE;
        case BoundaryInterpolation::edges:
            return CANDELA_BOUNDARY_EDGES;
        default:
            return CANDELA_BOUNDARY_EDGES_AND_CORNERS;
    }
}

candela_face_varying_interpolation faceVaryingOf(FaceVaryingInterpolation faceVarying) {
    switch (faceVarying) {
        case FaceVaryingInterpolation::none:
            return CANDELA_FACE_VARYING_NONE;
        case FaceVaryingInterpolation::cornersPlus1:
            return CANDELA_FACE_VARYING_CORNERS_PLUS1;
        case FaceVaryingInterpolation::cornersPlus2:
            return CANDELA_FACE_VARYING_CORNERS_PLUS2;
        case FaceVaryingInterpolation::boundaries:
            return CANDELA_FACE_VARYING_BOUNDARIES;
        case FaceVaryingInterpolation::all:
            return CANDELA_FACE_VARYING_ALL;
        default:
            return CANDELA_FACE_VARYING_CORNERS_ONLY;
    }
}

}  // namespace

CageStruct::CageStruct(const Cage& cage) {
    struct_.struct_size = sizeof struct_;
    struct_.name = cage.name.c_str();
    setRules(cage);
    setFaces(cage);
    setSharpness(cage);
}

void CageStruct::setRules(const Cage& cage) {
    struct_.scheme = schemeOf(cage.scheme);
    struct_.boundary_interpolation = boundaryOf(cage.boundaryInterpolation);
    struct_.face_varying_interpolation = faceVaryingOf(cage.faceVaryingInterpolation);
    struct_.crease_method =
        cage.creaseMethod == CreaseMethod::chaikin ? CANDELA_CREASE_CHAIKIN : CANDELA_CREASE_UNIFORM;
    struct_.triangle_subdivision = cage.triangleSubdivision == TriangleSubdivision::smooth
                                       ? CANDELA_TRIANGLE_SMOOTH
                                       : CANDELA_TRIANGLE_CATMULL_CLARK;
    struct_.level = cage.level.value_or(0);
}

void CageStruct::setFaces(const Cage& cage) {
    struct_.vertex_count = countOf(cage.positions, "vertices", cage);
    struct_.positions = reinterpret_cast<const float*>(cage.positions.data());
    struct_.face_count = countOf(cage.faceSizes, "faces", cage);
    struct_.face_sizes = cage.faceSizes.data();
    countOf(cage.faceVertices, "corners", cage);
    struct_.face_vertices = cage.faceVertices.data();
    struct_.uv_count = countOf(cage.uvs, "texture coordinates", cage);
    struct_.uvs = reinterpret_cast<const float*>(cage.uvs.data());
    struct_.face_uvs = cage.faceUvs.data();
    struct_.hole_count = countOf(cage.holes, "holes", cage);
    struct_.holes = cage.holes.data();
}

void CageStruct::setSharpness(const Cage& cage) {
    struct_.crease_count = countOf(cage.creases, "creases", cage);
    for (const Crease& crease : cage.creases) {
        creaseEdges_.insert(creaseEdges_.end(), {crease.vertex0, crease.vertex1});
        creaseSharpness_.push_back(crease.sharpness);
    }
    struct_.crease_edges = creaseEdges_.data();
    struct_.crease_sharpness = creaseSharpness_.data();
    struct_.corner_count = countOf(cage.corners, "corners", cage);
    for (const Corner& corner : cage.corners) {
        cornerVertices_.push_back(corner.vertex);
        cornerSharpness_.push_back(corner.sharpness);
    }
    struct_.corner_vertices = cornerVertices_.data();
    struct_.corner_sharpness = cornerSharpness_.data();
}

// The C functions of the interface. `self` is the object.
struct Refinement::Functions {
    static Refinement& from(void* self) { return *static_cast<Refinement*>(self); }

    static void fail(void* self, const char* element, const char* reason) {
        from(self).guarded([&] {
            const std::string at = element && *element ? oneLine(element) + ": " : std::string();
            if (!reason || !*reason)
                from(self).refuse(
                    joined(at, "the plugin '", from(self).plugin_.plugin.name, "' gives no reason"));
            from(self).refuse(at + oneLine(reason));
        });
    }
    static candela_status setResult(void* self, const candela_refined_cage* result) {
        return from(self).guarded([&] { from(self).setResult(result); }) ? CANDELA_OK : CANDELA_FAILED;
    }
    static void parallelFor(void* self, std::uint32_t count, candela_parallel_body body, void* context) {
        runParallelLoop(*from(self).pool_, count, body, context);
    }
};

Refinement::Refinement(const LoadedPlugin& plugin, const Cage& cage, const candela_cage& cageStruct)
    : plugin_(plugin), cage_(cage), cageStruct_(cageStruct), pool_(ThreadPool::shared()) {}

void Refinement::refuse(const std::string& text) const {
    AbiReader("cage", std::nullopt, cage_.name.c_str()).refuse(text);
}

void Refinement::failForPlugin(const char* how) const {
    refuse(joined("the plugin '", plugin_.plugin.name, "' ", how));
}

// Runs an action of the plugin. After the first failure it runs none.
template <class Action>
bool Refinement::guarded(Action action) noexcept {
    if (failure_) return false;
    try {
        action();
        return true;
    } catch (...) {
        failure_ = std::current_exception();
        return false;
    }
}

void Refinement::setResult(const candela_refined_cage* result) {
    if (refined_) failForPlugin("sets more than one result");
    const std::string kind = joined("the table of the plugin '", plugin_.plugin.name, "' for cage");
    const AbiReader element(kind.c_str(), std::nullopt, cage_.name.c_str());
    if (!result) element.refuse("it is NULL");
    const auto copy = copyOf(result);
    if (!copy) element.refuse("struct_size " + sizeFault(result));
    refined_ = refinedCageFrom(*copy, element, cage_);
}

// A plugin must not throw. An exception that can be caught becomes an error like others.
void Refinement::call(std::uint32_t level) {
    candela_refinement interface {};
    interface.struct_size = sizeof interface;
    interface.self = this;
    interface.fail = Functions::fail;
    interface.set_result = Functions::setResult;
    interface.worker_count = pool_->size();
    interface.parallel_for = Functions::parallelFor;
    candela_status status = CANDELA_FAILED;
    try {
        status = plugin_.subdivider.refine(&interface, &cageStruct_, level);
    } catch (const std::bad_alloc&) {
        if (!failure_) throw;
    } catch (const std::length_error&) {
        if (!failure_) throw;
    } catch (...) {
        if (!failure_) failForPlugin("threw an exception, which the plugin interface forbids");
    }
    if (failure_) std::rethrow_exception(failure_);
    if (status != CANDELA_OK) failForPlugin("failed and gave no reason");
    if (!refined_) failForPlugin("has set no result");
}

RefinedCage Refinement::run(std::uint32_t level) {
    const auto notEnough = [&] {
        const AbiReader element("cage", std::nullopt, cage_.name.c_str());
        return Error(ErrorKind::limit, "",
                     joined(element.label(), ": there is not enough memory to refine it to level ", level));
    };
    try {
        call(level);
    } catch (const std::bad_alloc&) {
        throw notEnough();
    } catch (const std::length_error&) {
        throw notEnough();
    }
    refined_->level = level;
    return std::move(*refined_);
}

namespace {

void checkLevel(const Cage& cage, std::uint32_t level) {
    const AbiReader element("cage", std::nullopt, cage.name.c_str());
    if (level < 1 || level > maxSubdivisionLevel)
        element.refuse(joined("it was to be refined to level ", level, ", but 1 to ", maxSubdivisionLevel,
                              " was expected"));
    // In every scheme a corner of a face with a surface becomes 4^level corners.
    if (!cage.holes.empty() || cage.boundaryInterpolation == BoundaryInterpolation::none) return;
    const std::uint64_t corners = std::uint64_t{cage.faceVertices.size()} << (2 * level);
    if (corners > std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorKind::limit, "",
                    joined(element.label(), ": at level ", level, " it has ", corners,
                           " corners, more than 32 bits can count"));
}

}  // namespace

Subdivider::Subdivider(std::shared_ptr<const State> state) : state_(std::move(state)) {}

const Subdivider::State& Subdivider::state() const {
    if (state_) return *state_;
    throw Error(ErrorKind::badInput, "", "the subdivider was moved from, but one of a plugin was expected");
}

const std::string& Subdivider::name() const {
    return state().name;
}

RefinedCage Subdivider::refine(const Cage& cage, std::uint32_t level) const {
    const State& state = this->state();
    validateCageSurface(cage, ErrorContext("cage", std::nullopt, cage.name));
    checkLevel(cage, level);
    const CageStruct cageStruct(cage);
    return Refinement(*state.plugin, cage, cageStruct.get()).run(level);
}

}  // namespace candela
