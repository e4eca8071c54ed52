#include "cage_rules.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace candela_plugins::obj {

namespace {

candela_scheme schemeOf(std::string_view name) {
    if (name == "catmullClark") return CANDELA_SCHEME_CATMULL_CLARK;
    if (name == "loop") return CANDELA_SCHEME_LOOP;
    if (name == "bilinear") return CANDELA_SCHEME_BILINEAR;
    throw Failure{"query", "subdivide=" + readable(std::string(name)) +
                               ", but catmullClark, loop or bilinear was expected"};
}

std::uint32_t levelOf(std::string_view digits) {
    if (digits.size() == 1 && digits[0] >= '1' && digits[0] <= '8')
        return static_cast<std::uint32_t>(digits[0] - '0');
    throw Failure{"query", "level=" + readable(std::string(digits)) + ", but 1 to 8 was expected"};
}

void readItem(std::string_view item, Query& query) {
    constexpr std::string_view scheme = "subdivide=", level = "level=";
    query.subdivide = true;
    if (item == "subdivide") return;
    if (item.starts_with(scheme)) {
        query.scheme = schemeOf(item.substr(scheme.size()));
    } else if (item.starts_with(level)) {
        query.level = levelOf(item.substr(level.size()));
    } else {
        throw Failure{"query", "'" + readable(std::string(item)) +
                                   "', but subdivide, subdivide=SCHEME or level=N was expected"};
    }
}

}  // namespace

Query parseQuery(const char* text) {
    Query query;
    if (!text) return query;
    std::string_view left = text;
    while (true) {
        const std::size_t end = left.find('&');
        readItem(left.substr(0, end), query);
        if (end == std::string_view::npos) return query;
        left.remove_prefix(end + 1);
    }
}

namespace {

std::string numberText(std::int64_t number) {
    return std::to_string(number);
}

class RuleReader {
  public:
    RuleReader(const Document& document, candela_scheme scheme, const Host& host)
        : document_(document), scheme_(scheme), host_(host) {}

    CageRules read() {
        for (const Tag& tag : document_.tags) {
            if (host_.leavesOut([&] { readTag(tag); })) continue;
            if (tag.surplusWords == 0) continue;
            host_.note(CANDELA_NOTE_REPAIRED, tag.place,
                       std::to_string(tag.surplusWords) + " surplus words of the tag '" + readable(tag.name) +
                           "' are not used");
        }
        propagateCorners();
        return std::move(rules_);
    }

  private:
    void readTag(const Tag& tag) {
        if (tag.name == "crease") return readCreases(tag);
        if (tag.name == "corner") return readCorners(tag);
        if (tag.name == "hole") return readHoles(tag);
        if (tag.name == "interpolateboundary") return readBoundary(tag);
        if (tag.name == "facevaryinginterpolateboundary") return readFaceVarying(tag);
        if (tag.name == "facevaryingpropagatecorners") return readPropagation(tag);
        if (tag.name == "creasemethod") return readCreaseMethod(tag);
        if (tag.name == "smoothtriangles") return readTriangles(tag);
        host_.note(CANDELA_NOTE_MISSING, tag.place, "the tag '" + readable(tag.name) + "' is not used");
    }

    std::uint32_t indexOf(const Tag& tag, std::int64_t index, std::size_t count, const char* what) const {
        if (index >= 0 && index < static_cast<std::int64_t>(count)) return static_cast<std::uint32_t>(index);
        throw tag.failure(std::string(what) + " " + numberText(index) + ", but 0 to " +
                          numberText(static_cast<std::int64_t>(count) - 1) + " was expected");
    }

    std::uint32_t vertexOf(const Tag& tag, std::size_t i) const {
        return indexOf(tag, tag.integers[i], document_.positions.size(), "vertex");
    }

    static float checkedSharpness(const Tag& tag, float sharpness) {
        if (sharpness >= 0.0f) return sharpness;
        throw tag.failure("sharpness " + std::to_string(sharpness) + ", but 0 or more was expected");
    }

    /// Pairs of vertices with one sharpness for all, one for each pair, or one for each vertex, of which
    /// OpenSubdiv's reader takes the first of each pair.
    void readCreases(const Tag& tag) {
        const std::size_t integers = tag.integers.size(), numbers = tag.numbers.size();
        if (integers == 0 || integers % 2 != 0)
            throw tag.failure(std::to_string(integers) + " vertices, but pairs were expected");
        if (numbers != 1 && numbers != integers / 2 && numbers != integers) {
            throw tag.failure(std::to_string(numbers) +
                              " numbers, but one sharpness or one a pair of vertices was expected");
        }
        const std::size_t step = numbers == 1 ? 0 : numbers == integers ? 2 : 1;
        // Of a tag that is left out nothing is used.
        std::vector<SharpEdge> creases;
        for (std::size_t pair = 0; pair < integers / 2; ++pair) {
            const std::uint32_t a = vertexOf(tag, 2 * pair), b = vertexOf(tag, 2 * pair + 1);
            const float sharpness = checkedSharpness(tag, tag.numbers[pair * step]);
            creases.push_back({a, b, sharpness, &tag, none});
        }
        for (const SharpEdge& crease : creases)
            rules_.creases[edgeKey(crease.vertex0, crease.vertex1)] = crease;
    }

    void readCorners(const Tag& tag) {
        const std::size_t numbers = tag.numbers.size();
        if (tag.integers.empty()) throw tag.failure("no vertex is named");
        if (numbers != 1 && numbers != tag.integers.size()) {
            throw tag.failure(std::to_string(numbers) +
                              " numbers, but one sharpness or one a vertex was expected");
        }
        std::vector<std::pair<std::uint32_t, float>> corners;
        for (std::size_t i = 0; i < tag.integers.size(); ++i) {
            const float sharpness = checkedSharpness(tag, tag.numbers[numbers == 1 ? 0 : i]);
            corners.emplace_back(vertexOf(tag, i), sharpness);
        }
        for (const auto& [vertex, sharpness] : corners) rules_.cornerSharpness[vertex] = sharpness;
    }

    void readHoles(const Tag& tag) {
        const std::vector<std::uint32_t>& leftOut = document_.leftOutFaces;
        if (tag.integers.empty()) throw tag.failure("no face is named");
        std::vector<std::uint32_t> holes;
        for (const std::int64_t face : tag.integers)
            holes.push_back(indexOf(tag, face, document_.faces.size() + leftOut.size(), "face"));
        rules_.isHole.resize(document_.faces.size());
        for (const std::uint32_t face : holes) {
            const auto before = std::lower_bound(leftOut.begin(), leftOut.end(), face);
            const bool isLeftOut = before != leftOut.end() && *before == face;
            if (!isLeftOut) rules_.isHole[face - static_cast<std::size_t>(before - leftOut.begin())] = true;
        }
    }

    static std::int64_t oneInteger(const Tag& tag) {
        if (tag.integers.size() != 1) throw tag.failure("one whole number was expected");
        return tag.integers[0];
    }

    template <class Rule, std::size_t count>
    static Rule enumerator(const Tag& tag, const std::array<Rule, count>& rules) {
        const std::int64_t number = oneInteger(tag);
        if (number >= 0 && number < static_cast<std::int64_t>(count)) return rules[number];
        throw tag.failure(numberText(number) + ", but 0 to " + std::to_string(count - 1) + " was expected");
    }

    void readBoundary(const Tag& tag) {
        rules_.boundary = enumerator(
            tag,
            std::array{CANDELA_BOUNDARY_NONE, CANDELA_BOUNDARY_EDGES_AND_CORNERS, CANDELA_BOUNDARY_EDGES});
    }

    void readFaceVarying(const Tag& tag) {
        rules_.faceVarying =
            enumerator(tag, std::array{CANDELA_FACE_VARYING_NONE, CANDELA_FACE_VARYING_CORNERS_ONLY,
                                       CANDELA_FACE_VARYING_CORNERS_PLUS1, CANDELA_FACE_VARYING_CORNERS_PLUS2,
                                       CANDELA_FACE_VARYING_BOUNDARIES, CANDELA_FACE_VARYING_ALL});
    }

    void readPropagation(const Tag& tag) { propagation_ = oneInteger(tag) != 0 ? &tag : nullptr; }

    /// What OpenSubdiv 2 called "edge and corner", with and without propagated corners, is "corners plus 2"
    /// and "corners plus 1" since OpenSubdiv 3. It did not affect other rules.
    void propagateCorners() {
        if (!propagation_) return;
        if (rules_.faceVarying == CANDELA_FACE_VARYING_CORNERS_PLUS1)
            rules_.faceVarying = CANDELA_FACE_VARYING_CORNERS_PLUS2;
        else if (rules_.faceVarying != CANDELA_FACE_VARYING_CORNERS_PLUS2)
            host_.note(CANDELA_NOTE_INFORMATION, propagation_->place,
                       "the tag 'facevaryingpropagatecorners' changes nothing without "
                       "'facevaryinginterpolateboundary 1/0/0 2'");
    }

    static const std::string& oneText(const Tag& tag, const char* expected) {
        if (tag.texts.size() != 1) throw tag.failure(std::string(expected) + " was expected");
        return tag.texts[0];
    }

    void readCreaseMethod(const Tag& tag) {
        constexpr const char* expected = "'normal' or 'chaikin'";
        const std::string& text = oneText(tag, expected);
        if (text != "normal" && text != "chaikin")
            throw tag.failure("'" + readable(text) + "', but " + expected + " was expected");
        rules_.creaseMethod = text == "normal" ? CANDELA_CREASE_UNIFORM : CANDELA_CREASE_CHAIKIN;
    }

    /// OpenSubdiv 2 wrote 1 for the Catmull-Clark weights and 2 for the smooth ones, OpenSubdiv 3 writes
    /// names.
    void readTriangles(const Tag& tag) {
        if (scheme_ != CANDELA_SCHEME_CATMULL_CLARK) {
            host_.note(CANDELA_NOTE_INFORMATION, tag.place,
                       "the tag 'smoothtriangles' is not used: the scheme is not Catmull-Clark");
            return;
        }
        constexpr const char* expected = "'catmark', 'smooth', 1 or 2";
        const bool isNumber = tag.integers.size() == 1 && tag.texts.empty();
        const std::string text = isNumber ? numberText(tag.integers[0]) : oneText(tag, expected);
        const bool smooth = text == "smooth" || text == "2";
        if (!smooth && text != "catmark" && text != "1")
            throw tag.failure("'" + readable(text) + "', but " + expected + " was expected");
        rules_.triangles = smooth ? CANDELA_TRIANGLE_SMOOTH : CANDELA_TRIANGLE_CATMULL_CLARK;
    }

    const Document& document_;
    const candela_scheme scheme_;
    const Host& host_;
    const Tag* propagation_ = nullptr;
    CageRules rules_;
};

}  // namespace

std::uint64_t edgeKey(std::uint32_t vertex0, std::uint32_t vertex1) {
    const auto [low, high] = std::minmax(vertex0, vertex1);
    return std::uint64_t{low} << 32 | high;
}

CageRules readCageRules(const Document& document, candela_scheme scheme, const Host& host) {
    return RuleReader(document, scheme, host).read();
}

}  // namespace candela_plugins::obj
