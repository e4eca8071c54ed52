#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "document.h"
#include "references.h"
#include "statement.h"

namespace candela_plugins::obj {
namespace {

/// Reads the corners of faces, lines and points: "v", "v/t", "v//n" and "v/t/n".
class CornerReader {
  public:
    explicit CornerReader(Document& document) : document_(document) {}

    void readFace(Statement& statement) {
        while (auto word = statement.word()) {
            document_.corners.push_back(read(*word));
            if (document_.corners.back().vertex >= outOfRange) noteFault(statement, nextPart(*word));
        }
    }
    void readLooseElement(Statement& statement) {
        while (const auto word = statement.word()) document_.looseCorners.push_back(read(*word));
    }

  private:
    Corner read(std::string_view word) {
        Corner corner;
        const std::string_view vertex = nextPart(word), uv = nextPart(word), normal = nextPart(word);
        const std::optional<std::int64_t> index = integerIn(vertex);
        if (index) corner.vertex = resolved(*index, document_.positions.size());
        corner.uv = optionalIndex(uv, document_.uvs.size());
        corner.normal = optionalIndex(normal, document_.normals.size());
        return corner;
    }

    static std::uint32_t optionalIndex(std::string_view text, std::size_t count) {
        if (text.empty()) return none;
        const std::optional<std::int64_t> index = integerIn(text);
        return index ? resolved(*index, count) : outOfRange;
    }

    /// The text up to the next '/', which is taken off `word`.
    static std::string_view nextPart(std::string_view& word) {
        const std::size_t slash = std::min(word.find('/'), word.size());
        const std::string_view part = word.substr(0, slash);
        word.remove_prefix(std::min(slash + 1, word.size()));
        return part;
    }

    /// Negative indices count back from the elements read so far; the others may be of elements to come.
    static std::uint32_t resolved(std::int64_t index, std::size_t count) {
        if (index > 0 && index <= std::int64_t{outOfRange}) return static_cast<std::uint32_t>(index - 1);
        const auto signedCount = static_cast<std::int64_t>(count);
        if (index < 0 && index >= -signedCount) return static_cast<std::uint32_t>(signedCount + index);
        return outOfRange;
    }

    void noteFault(const Statement& statement, std::string_view vertex) {
        if (document_.faceFault) return;
        const std::size_t count = document_.positions.size();
        const std::optional<std::int64_t> index = integerIn(vertex);
        std::string reason =
            "'" + readable(std::string(vertex)) + "', but the index of a vertex was expected";
        if (index)
            reason =
                "vertex " + std::string(vertex) +
                (*index == 0 ? ", but they count from 1"
                             : ", but " + std::to_string(count) + (count == 1 ? " is there" : " are there"));
        document_.faceFault = LineFault{statement.line(), statement.failure(reason)};
    }

    Document& document_;
};

// The maximum that `validate` allows.
constexpr double maxCoordinate = 1e9;
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// Vertex colours are from photographs and scans, and are sRGB-encoded (IEC 61966-2-1).
float linearOf(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

/// The numbers of a statement; what is no number is NaN.
struct Numbers {
    std::array<double, 7> values{};
    std::size_t count = 0;  ///< Of the words, which may be more than the values.

    /// Whether the first `size` of them are there, and from -limit to limit.
    bool areWithin(std::size_t size, double limit) const {
        const auto end = values.begin() + static_cast<std::ptrdiff_t>(size);
        return count >= size &&
               std::all_of(values.begin(), end, [&](double value) { return std::abs(value) <= limit; });
    }
    Vec3 vector(std::size_t first) const {
        return {static_cast<float>(values[first]), static_cast<float>(values[first + 1]),
                static_cast<float>(values[first + 2])};
    }
};

class Parser {
  public:
    Parser(const Bytes& file, const Host& host, double progressEnd)
        : file_(file), host_(host), progressEnd_(progressEnd), lines_(textOf(file)), corners_(document_) {
        document_.objects.indexOf("");
        document_.groups.indexOf("");
    }

    Document parse() {
        while (lines_.next()) {
            reportProgress();
            Statement statement(lines_.line(), lines_.number(), sceneFile_);
            read(statement);
        }
        decodeColors();
        notes_.add(host_, sceneFile_);
        if (document_.faces.empty() && document_.looseElements.empty() && !hasOtherGeometry_)
            throw Failure{"", "no face, line or point was found, but an OBJ file was expected"};
        return std::move(document_);
    }

  private:
    void reportProgress() {
        constexpr std::size_t step = 1u << 20;
        if (lines_.position() < nextProgress_) return;
        nextProgress_ = lines_.position() + step;
        host_.progress(progressEnd_ * static_cast<double>(lines_.position()) /
                       static_cast<double>(file_.size));
    }

    void read(Statement& statement) {
        const std::string_view keyword = statement.keyword();
        if (keyword == "v") return readVertex(statement);
        if (keyword == "vt") return readUv(statement);
        if (keyword == "vn") return readNormal(statement);
        if (keyword == "f" || keyword == "fo") return readFace(statement);
        if (keyword == "l") return readLooseElement(statement, CANDELA_LINES);
        if (keyword == "p") return readLooseElement(statement, CANDELA_POINTS);
        readOther(statement, keyword);
    }

    void readOther(Statement& statement, std::string_view keyword) {
        if (keyword == "o") {
            state_.object = document_.objects.indexOf(statement.rest());
        } else if (keyword == "g") {
            state_.group = document_.groups.indexOf(statement.rest());
        } else if (keyword == "s") {
            readSmoothing(statement);
        } else if (keyword == "usemtl") {
            state_.material = document_.materials.indexOf(statement.rest());
        } else if (keyword == "mtllib") {
            readLibraries(statement);
        } else if (keyword == "t") {
            host_.leavesOut([&] { document_.tags.push_back(parseTag(statement)); });
        } else if (!readInLowerCase(statement, keyword)) {
            countIgnored(statement, keyword);
        }
    }

    /// Some programs write keywords in other cases.
    bool readInLowerCase(Statement& statement, std::string_view keyword) {
        constexpr std::string_view known[] = {"v", "vt", "vn", "f", "usemtl", "mtllib"};
        const std::string lower = lowerCase(keyword);
        const auto found = std::find(std::begin(known), std::end(known), lower);
        if (found == std::end(known) || lower == keyword) return false;
        statement.setKeyword(*found);
        read(statement);
        return true;
    }

    Numbers readNumbers(Statement& statement) {
        Numbers numbers;
        while (const auto word = statement.word()) {
            if (numbers.count < numbers.values.size())
                numbers.values[numbers.count] = numberOf(*word, statement.line());
            ++numbers.count;
        }
        return numbers;
    }

    double numberOf(std::string_view word, std::size_t line) {
        if (const auto value = numberIn(word)) return *value;
        const auto value = numberWithCommaIn(word);
        if (value) notes_.count(CANDELA_NOTE_REPAIRED, "decimal commas, read as points", line);
        return value.value_or(std::numeric_limits<double>::quiet_NaN());
    }

    void readVertex(Statement& statement) {
        requireRoom(statement, document_.positions.size());
        const std::string_view text = statement.rest();
        Numbers numbers = readNumbers(statement);
        const bool isFlat = numbers.count == 2;
        if (isFlat) {
            notes_.count(CANDELA_NOTE_REPAIRED, "vertices of two coordinates: z is taken as 0",
                         statement.line());
            numbers.count = 3;
        }
        // x y z, x y z w, x y z r g b, and an alpha or a weight behind it.
        if (numbers.count == 5 || numbers.count > 7)
            notes_.count(CANDELA_NOTE_REPAIRED,
                         "vertices of more numbers than x y z r g b: only x y z is used", statement.line());
        const bool isUsable = numbers.areWithin(3, maxCoordinate);
        if (!isUsable) noteVertexFault(statement, text);
        document_.positions.push_back(isUsable ? numbers.vector(0) : Vec3{nan, 0.0f, 0.0f});
        if (isUsable) keepResidual(numbers);
        takeColor(numbers);
    }

    /// Far from the origin single precision is coarser than the file.
    void keepResidual(const Numbers& numbers) {
        constexpr double farCoordinate = 16384.0;  // There floats are a millimetre apart.
        if (document_.residuals.empty() && numbers.areWithin(3, farCoordinate)) return;
        const std::array<double, 7>& exact = numbers.values;
        // Read back, and not rounded again: GCC 12 vectorises x - double(float(x)) to 0.
        const Vec3 position = document_.positions.back();
        document_.residuals.resize(document_.positions.size());
        Vec3& residual = document_.residuals.back();
        residual.x = static_cast<float>(exact[0] - double{position.x});
        residual.y = static_cast<float>(exact[1] - double{position.y});
        residual.z = static_cast<float>(exact[2] - double{position.z});
    }

    void noteVertexFault(const Statement& statement, std::string_view text) {
        notes_.count(CANDELA_NOTE_INFORMATION, "vertices without three numbers of at most 1e+09",
                     statement.line());
        if (document_.vertexFault) return;
        document_.vertexFault = LineFault{
            statement.line(),
            statement.failure(inQuotes(text) + ", but three numbers of at most 1e+09 were expected")};
    }

    /// As it is in the file: only all of them tell the range.
    void takeColor(const Numbers& numbers) {
        const bool hasColor = numbers.count == 6 || numbers.count == 7;
        std::vector<Vec3>& colors = document_.colors;
        if (!hasColor && colors.empty()) return;
        colors.resize(document_.positions.size(), noColor);
        if (hasColor) colors.back() = numbers.vector(3);
    }

    /// Colours are 0 to 1, or 0 to 255 in some files.
    void decodeColors() {
        float max = 0.0f;
        for (const Vec3& color : document_.colors)
            for (const float value : {color.x, color.y, color.z})
                max = std::max(max, std::isfinite(value) ? value : 0.0f);
        // What is above 1 by less is taken for an error of rounding.
        constexpr float maxFraction = 1.5f, maxByte = 255.0f;
        const bool areBytes = max > maxFraction && max <= maxByte;
        if (areBytes)
            host_.note(CANDELA_NOTE_REPAIRED, "", "colours of vertices from 0 to 255: divided by 255");
        std::size_t held = 0;
        for (Vec3& color : document_.colors) {
            const bool isGiven = !isNoColor(color);
            for (float* const value : {&color.x, &color.y, &color.z}) {
                const float fraction = areBytes ? *value / maxByte : *value;
                const float usable = std::isnan(fraction) ? 1.0f : std::clamp(fraction, 0.0f, 1.0f);
                if (usable != fraction && isGiven) ++held;
                *value = linearOf(usable);
            }
        }
        if (held > 0)
            host_.note(CANDELA_NOTE_REPAIRED, "", "colours of vertices beyond 0 to 1: held at the limit");
    }

    void readUv(Statement& statement) {
        requireRoom(statement, document_.uvs.size());
        const Numbers numbers = readNumbers(statement);
        const bool isUsable = numbers.areWithin(std::clamp<std::size_t>(numbers.count, 1, 2), maxCoordinate);
        const auto u = static_cast<float>(numbers.values[0]), v = static_cast<float>(numbers.values[1]);
        document_.uvs.push_back(isUsable ? Vec2{u, 1.0f - v} : Vec2{nan, 0.0f});
    }

    void readNormal(Statement& statement) {
        requireRoom(statement, document_.normals.size());
        const Numbers numbers = readNumbers(statement);
        const bool isUsable = numbers.areWithin(3, Statement::maxNumber);
        document_.normals.push_back(isUsable ? numbers.vector(0) : Vec3{nan, 0.0f, 0.0f});
    }

    void readFace(Statement& statement) {
        requireRoom(statement, document_.corners.size());
        document_.faces.push_back({static_cast<std::uint32_t>(document_.corners.size()), currentState(),
                                   static_cast<std::uint32_t>(statement.line())});
        corners_.readFace(statement);
    }

    void readLooseElement(Statement& statement, candela_topology topology) {
        requireRoom(statement, document_.looseCorners.size());
        document_.looseElements.push_back({topology,
                                           static_cast<std::uint32_t>(document_.looseCorners.size()),
                                           currentState(), static_cast<std::uint32_t>(statement.line())});
        corners_.readLooseElement(statement);
    }

    /// The index of the present state.
    std::uint32_t currentState() {
        if (document_.states.empty() || document_.states.back() != state_) document_.states.push_back(state_);
        return static_cast<std::uint32_t>(document_.states.size() - 1);
    }

    void readSmoothing(Statement& statement) {
        const std::string_view word = statement.word().value_or("off");
        const std::optional<std::int64_t> group = integerIn(word);
        const bool isGroup = group && *group >= 0 && *group < std::int64_t{none};
        if (!isGroup && word != "on" && word != "off")
            notes_.count(CANDELA_NOTE_REPAIRED,
                         "smoothing groups that are neither a number nor 'off': taken as off",
                         statement.line());
        state_.smoothing = isGroup ? static_cast<std::uint32_t>(*group) : word == "on" ? 1 : 0;
    }

    void readLibraries(Statement& statement) {
        const std::vector<std::string> names = libraryNames(statement.rest());
        if (names.empty())
            notes_.count(CANDELA_NOTE_REPAIRED, "mtllib without the name of a file: not used",
                         statement.line());
        for (const std::string& name : names) document_.materialFiles.indexOf(name);
    }

    /// Counts statements that are not drawn, not used or not known. Those that are part of a free-form shape,
    /// which is counted, and those of other renderers are skipped.
    void countIgnored(const Statement& statement, std::string_view keyword) {
        struct Geometry {
            std::string_view keyword;
            const char* text;
        };
        static constexpr Geometry geometries[] = {
            {"curv", "not drawn: curves (curv)"},   {"curv2", "not drawn: curves (curv2)"},
            {"surf", "not drawn: surfaces (surf)"}, {"bzp", "not drawn: patches (bzp)"},
            {"bsp", "not drawn: patches (bsp)"},    {"cdp", "not drawn: patches (cdp)"},
            {"cdc", "not drawn: curves (cdc)"}};
        static constexpr std::string_view skipped[] = {
            "vp",    "cstype",   "deg",      "bmat", "step",       "parm",     "trim",  "hole",
            "scrv",  "sp",       "end",      "con",  "mg",         "res",      "ctech", "stech",
            "bevel", "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj"};
        static constexpr std::string_view missing[] = {"usemap", "maplib", "call", "csh"};
        for (const Geometry& geometry : geometries) {
            if (keyword != geometry.keyword) continue;
            hasOtherGeometry_ = true;
            return notes_.count(CANDELA_NOTE_MISSING, geometry.text, statement.line());
        }
        const auto isOneOf = [&](const auto& known) {
            return std::find(std::begin(known), std::end(known), keyword) != std::end(known);
        };
        if (isOneOf(skipped)) return;
        if (isOneOf(missing))
            return notes_.count(CANDELA_NOTE_MISSING, "not used: " + std::string(keyword), statement.line());
        notes_.countUnknown(keyword, statement.line());
    }

    /// Indices have 32 bits, and a face adds fewer corners than a file of 4 GiB can hold.
    static void requireRoom(const Statement& statement, std::size_t count) {
        constexpr std::size_t maxCount = 1u << 31;
        if (count >= maxCount) statement.fail("there are more than 2147483648 of them");
    }

    /// Of a vertex without a colour in a file that has some: it is white.
    static constexpr Vec3 noColor{nan, nan, nan};

    static bool isNoColor(const Vec3& color) {
        return std::isnan(color.x) && std::isnan(color.y) && std::isnan(color.z);
    }

    const Bytes file_;
    const Host& host_;
    const double progressEnd_;
    const std::string sceneFile_;  // empty: failures need not name it
    Lines lines_;
    std::size_t nextProgress_ = 0;
    Document document_;
    CornerReader corners_;
    FaceState state_;
    LineNotes notes_;
    bool hasOtherGeometry_ = false;
};

}  // namespace

Document parseObj(const Bytes& file, const Host& host, double progressEnd) {
    if (isUtf16(textOf(file))) throw Failure{"", "UTF-16 text, but an OBJ file is UTF-8"};
    return Parser(file, host, progressEnd).parse();
}

}  // namespace candela_plugins::obj
