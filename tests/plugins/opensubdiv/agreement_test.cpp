#include "expect_agreement.h"
#include "generated_cages.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

namespace candela {
namespace {

std::vector<Cage> manifoldCages() {
    std::vector<Cage> cages{cube(), torus(5, 4), pyramid(3), pyramid(5), sheet(3, 3), mixedPolygons()};
    for (std::uint32_t valence = 3; valence <= 12; ++valence) cages.push_back(star(valence));
    return cages;
}

/// The cage itself, or triangulated for the Loop scheme.
Cage convertedTo(SubdivisionScheme scheme, const Cage& cage) {
    Cage converted = scheme == SubdivisionScheme::loop ? triangulated(cage) : cage;
    converted.scheme = scheme;
    return converted;
}

struct Rules {
    FaceVaryingInterpolation faceVarying;
    CreaseMethod creases;
    TriangleSubdivision triangles;
};

std::vector<Rules> allRules(SubdivisionScheme scheme) {
    std::vector<Rules> rules;
    for (int faceVarying = 0; faceVarying <= static_cast<int>(FaceVaryingInterpolation::all); ++faceVarying) {
        for (const CreaseMethod creases : {CreaseMethod::uniform, CreaseMethod::chaikin}) {
            for (const auto triangles : {TriangleSubdivision::catmullClark, TriangleSubdivision::smooth}) {
                if (triangles == TriangleSubdivision::smooth && scheme != SubdivisionScheme::catmullClark) {
                    continue;
                }
                rules.push_back({static_cast<FaceVaryingInterpolation>(faceVarying), creases, triangles});
            }
        }
    }
    return rules;
}

void set(Cage& cage, const Rules& rules) {
    cage.faceVaryingInterpolation = rules.faceVarying;
    cage.creaseMethod = rules.creases;
    cage.triangleSubdivision = rules.triangles;
    cage.name += ", face-varying rule " + std::to_string(static_cast<int>(rules.faceVarying)) +
                 ", crease method " + std::to_string(static_cast<int>(rules.creases)) + ", triangle rule " +
                 std::to_string(static_cast<int>(rules.triangles));
}

class Agreement : public testing::TestWithParam<std::tuple<SubdivisionScheme, BoundaryInterpolation>> {
  protected:
    Cage prepared(const Cage& cage) const {
        Cage result = convertedTo(std::get<0>(GetParam()), cage);
        result.boundaryInterpolation = std::get<1>(GetParam());
        return result;
    }
};

TEST_P(Agreement, ofSmoothCages) {
    Random random(1);
    for (const Cage& original : manifoldCages()) {
        for (const std::uint32_t level : {1u, 3u}) {
            Cage cage = prepared(original);
            jitter(cage, 0.1f, random);
            addUvsWithSeams(cage, random);
            expectAgreement(cage, level);
        }
    }
}

// Random creases, corners and seams, with all combinations of the other rules, each for some of the cages.
TEST_P(Agreement, ofSharpCages) {
    Random random(2);
    const std::vector<Cage> cages = manifoldCages();
    std::size_t iteration = 0;
    for (const Rules& rules : allRules(std::get<0>(GetParam()))) {
        for (int i = 0; i < 4; ++i) {
            Cage cage = prepared(cages[iteration++ % cages.size()]);
            set(cage, rules);
            jitter(cage, 0.2f, random);
            addUvsWithSeams(cage, random);
            addRandomSharpness(cage, random);
            expectAgreement(cage, 2);
        }
    }
}

TEST_P(Agreement, aroundHoles) {
    Random random(3);
    for (const Cage& original : {torus(6, 5), sheet(5, 4), star(5)}) {
        Cage cage = prepared(original);
        jitter(cage, 0.1f, random);
        addUvsWithSeams(cage, random);
        cage.holes = {3, 4, 9, 13};
        expectAgreement(cage, 2);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, Agreement,
    testing::Combine(testing::Values(SubdivisionScheme::catmullClark, SubdivisionScheme::loop,
                                     SubdivisionScheme::bilinear),
                     testing::Values(BoundaryInterpolation::none, BoundaryInterpolation::edges,
                                     BoundaryInterpolation::edgesAndCorners)));

// Sharpness above the refinement level is isolated too.
TEST(Agreement, ofHighSharpness) {
    Cage cage = cube();
    cage.creases = {{0, 1, 5.5f}, {1, 3, 5.5f}, {3, 2, 6.25f}, {2, 0, 4.0f}};
    cage.corners = {{7, 5.0f}};
    expectAgreement(cage, 1);
}

TEST(Agreement, ofNonManifoldEdges) {
    Random random(4);
    for (const SubdivisionScheme scheme : {SubdivisionScheme::catmullClark, SubdivisionScheme::loop}) {
        Cage cage = convertedTo(scheme, threeSheets());
        jitter(cage, 0.1f, random);
        expectAgreement(cage, 2);
    }
}

}  // namespace
}  // namespace candela
