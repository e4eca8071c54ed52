#include <array>
#include <cmath>

#include "document.h"
#include "statement.h"

namespace candela_plugins::obj {
namespace {

/// The three parts of "v/t/n" as they are written.
struct Parts {
    std::array<std::string_view, 3> texts;

    /// Which of texture coordinate and normal are there.
    bool operator==(const Parts& other) const {
        return texts[1].empty() == other.texts[1].empty() && texts[2].empty() == other.texts[2].empty();
    }
};

[[noreturn]] void failForm(const Statement& statement, std::string_view word) {
    statement.fail("'" + readable(std::string(word)) + "', but v, v/t, v//n or v/t/n was expected");
}

Parts partsOf(const Statement& statement, std::string_view word) {
    Parts parts;
    std::size_t begin = 0, count = 0;
    for (std::size_t i = 0; i <= word.size(); ++i) {
        if (i < word.size() && word[i] != '/') continue;
        if (count == parts.texts.size()) failForm(statement, word);
        parts.texts[count++] = word.substr(begin, i - begin);
        begin = i + 1;
    }
    if (parts.texts[0].empty()) failForm(statement, word);
    return parts;
}

std::string countOf(std::size_t count) {
    return std::to_string(count) + (count == 1 ? " is there" : " are there");
}

/// None when it is out of range; the reason then goes to `reason`.
std::uint32_t resolved(std::int64_t index, std::size_t count, const char* what, std::string& reason) {
    const auto signedCount = static_cast<std::int64_t>(count);
    if (index > 0 && index <= signedCount) return static_cast<std::uint32_t>(index - 1);
    if (index < 0 && index >= -signedCount) return static_cast<std::uint32_t>(signedCount + index);
    reason = std::string(what) + " " + std::to_string(index) + ", but " +
             (index == 0 ? "they count from 1" : countOf(count));
    return none;
}

class CornerReader {
  public:
    CornerReader(const Statement& statement, Document& document)
        : statement_(statement), document_(document) {}

    Corner read(const Parts& parts) {
        Corner corner;
        corner.vertex = need(parts.texts[0], document_.positions.size(), "vertex");
        if (!parts.texts[1].empty())
            corner.uv = need(parts.texts[1], document_.uvs.size(), "texture coordinate");
        if (!parts.texts[2].empty()) corner.normal = normal(parts.texts[2]);
        return corner;
    }

  private:
    std::uint32_t need(std::string_view text, std::size_t count, const char* what) const {
        std::string reason;
        const std::uint32_t index = resolved(statement_.integer(text), count, what, reason);
        if (index == none) statement_.fail(reason);
        return index;
    }

    std::uint32_t normal(std::string_view text) {
        std::string reason;
        const std::uint32_t index =
            resolved(statement_.integer(text), document_.normals.size(), "normal", reason);
        if (index == none && !document_.normalFault) document_.normalFault = statement_.failure(reason);
        return index;
    }

    const Statement& statement_;
    Document& document_;
};

void parseCorners(Statement& statement, Document& document) {
    CornerReader reader(statement, document);
    std::optional<Parts> form;
    std::size_t count = 0;
    for (; const auto word = statement.word(); ++count) {
        const Parts parts = partsOf(statement, *word);
        if (form && !(parts == *form)) statement.fail("all corners of a face must have the same form");
        form = parts;
        document.corners.push_back(reader.read(parts));
    }
    if (count < 3) statement.fail(std::to_string(count) + " corners, but 3 or more were expected");
}

using Counts = std::array<std::size_t, 3>;

Counts countsOf(const Statement& statement, const Tag& tag, std::string_view word) {
    Counts counts{};
    std::size_t slash = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const bool last = i + 1 == counts.size();
        slash = last ? word.size() : word.find('/');
        if (slash == std::string_view::npos || slash == 0)
            throw tag.failure("counts such as 2/1/0 were expected");
        const std::int64_t count = statement.integer(word.substr(0, slash));
        // No line has more words: the sum below does not overflow.
        constexpr std::int64_t maxWords = 1'000'000'000'000;
        if (count < 0 || count > maxWords) throw tag.failure("counts such as 2/1/0 were expected");
        counts[i] = static_cast<std::size_t>(count);
        if (!last) word.remove_prefix(slash + 1);
    }
    return counts;
}

Tag parseTag(Statement& statement) {
    Tag tag;
    tag.place = statement.place();
    tag.name = statement.needWord("the name of a tag");
    const Counts counts = countsOf(statement, tag, statement.needWord("counts such as 2/1/0"));
    const std::size_t announced = counts[0] + counts[1] + counts[2], present = statement.wordsLeft();
    if (announced > present) {
        throw tag.failure(std::to_string(announced) + " words were expected, but " + std::to_string(present) +
                          (present == 1 ? " follows" : " follow"));
    }
    for (std::size_t i = 0; i < counts[0]; ++i) tag.integers.push_back(statement.integer(*statement.word()));
    for (std::size_t i = 0; i < counts[1]; ++i) tag.numbers.push_back(statement.number(*statement.word()));
    for (std::size_t i = 0; i < counts[2]; ++i) tag.texts.emplace_back(*statement.word());
    tag.surplusWords = statement.wordsLeft();
    return tag;
}

// The maximum that `validate` allows.
constexpr double maxCoordinate = 1e9;

/// Vertex colours are from photographs and scans, and are sRGB-encoded (IEC 61966-2-1).
float linearOf(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

class Parser {
  public:
    Parser(const Bytes& file, const Host& host, double progressEnd)
        : file_(file),
          host_(host),
          progressEnd_(progressEnd),
          lines_({reinterpret_cast<const char*>(file.data), file.size}) {
        document_.objects.indexOf("");
        document_.groups.indexOf("");
    }

    Document parse() {
        while (lines_.next()) {
            reportProgress();
            Statement statement(lines_.line(), lines_.number(), sceneFile_);
            read(statement);
        }
        ignored_.note(host_, sceneFile_);
        if (document_.faces.empty() && !hasOtherGeometry_)
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
            document_.tags.push_back(parseTag(statement));
        } else {
            countIgnored(statement, keyword);
        }
    }

    void readVertex(Statement& statement) {
        const std::size_t numbers = statement.wordsLeft();
        const bool hasColor = numbers == 6 || numbers == 7;
        if (numbers != 3 && numbers != 4 && !hasColor) {
            statement.fail(std::to_string(numbers) +
                           " numbers, but x y z, x y z w or x y z r g b was expected");
        }
        requireRoom(statement, document_.positions.size());
        document_.positions.push_back(readVec3(statement, maxCoordinate));
        if (hasColor) readColor(statement);
        if (!hasColor && !document_.colors.empty()) document_.colors.push_back(white);
        while (const auto weight = statement.word()) statement.number(*weight);
    }

    void readColor(Statement& statement) {
        const Vec3 color = readVec3(statement, Statement::maxNumber);
        for (const float part : {color.x, color.y, color.z})
            if (part < 0.0f || part > 1.0f) statement.fail("a colour beyond 0 to 1");
        document_.colors.resize(document_.positions.size() - 1, white);
        document_.colors.push_back({linearOf(color.x), linearOf(color.y), linearOf(color.z)});
    }

    void readUv(Statement& statement) {
        requireRoom(statement, document_.uvs.size());
        const float u = statement.needNumber(maxCoordinate);
        const auto second = statement.word();
        const float v = second ? statement.number(*second, maxCoordinate) : 0.0f;
        document_.uvs.push_back({u, 1.0f - v});
        if (const auto third = statement.word()) statement.number(*third);
    }

    void readNormal(Statement& statement) {
        requireRoom(statement, document_.normals.size());
        document_.normals.push_back(readVec3(statement, Statement::maxNumber));
    }

    static Vec3 readVec3(Statement& statement, double limit) {
        Vec3 vector;
        vector.x = statement.needNumber(limit);
        vector.y = statement.needNumber(limit);
        vector.z = statement.needNumber(limit);
        return vector;
    }

    void readFace(Statement& statement) {
        requireRoom(statement, document_.corners.size());
        if (document_.states.empty() || document_.states.back() != state_) document_.states.push_back(state_);
        document_.faces.push_back({static_cast<std::uint32_t>(document_.corners.size()),
                                   static_cast<std::uint32_t>(document_.states.size() - 1),
                                   static_cast<std::uint32_t>(statement.line())});
        parseCorners(statement, document_);
    }

    void readSmoothing(Statement& statement) {
        const std::string_view word = statement.needWord("a number or 'off'");
        if (word == "off" || word == "on") {
            state_.smoothing = word == "on" ? 1 : 0;
            return;
        }
        const std::int64_t group = statement.integer(word);
        if (group < 0 || group >= none) statement.fail("a group from 0 to 4294967294 was expected");
        state_.smoothing = static_cast<std::uint32_t>(group);
    }

    void readLibraries(Statement& statement) {
        const std::vector<std::string> names = libraryNames(statement.rest());
        if (names.empty()) statement.fail("a file name was expected");
        for (const std::string& name : names) document_.materialFiles.push_back(besideFile("", name));
    }

    /// Counts statements that are not drawn, not used or not known. Those that are part of a free-form shape,
    /// which is counted, are skipped.
    void countIgnored(const Statement& statement, std::string_view keyword) {
        struct Geometry {
            std::string_view keyword, kind;
        };
        static constexpr Geometry geometries[] = {
            {"l", "lines (l)"},          {"p", "points (p)"},         {"curv", "curves (curv)"},
            {"curv2", "curves (curv2)"}, {"surf", "surfaces (surf)"}, {"bzp", "patches (bzp)"},
            {"bsp", "patches (bsp)"},    {"cdp", "patches (cdp)"},    {"cdc", "curves (cdc)"}};
        static constexpr std::string_view freeForm[] = {"vp",   "cstype", "deg",   "bmat", "step", "parm",
                                                        "trim", "hole",   "scrv",  "sp",   "end",  "con",
                                                        "mg",   "res",    "ctech", "stech"};
        static constexpr std::string_view unused[] = {"bevel",  "c_interp",   "d_interp",  "lod",  "usemap",
                                                      "maplib", "shadow_obj", "trace_obj", "call", "csh"};
        for (const Geometry& geometry : geometries) {
            if (keyword != geometry.keyword) continue;
            hasOtherGeometry_ = true;
            return ignored_.count("not drawn", geometry.kind, statement.line());
        }
        for (const std::string_view part : freeForm)
            if (keyword == part) return;
        for (const std::string_view known : unused)
            if (keyword == known) return ignored_.count("not used", keyword, statement.line());
        ignored_.count("not known", keyword, statement.line());
    }

    /// Indices have 32 bits, and a face adds fewer corners than a file of 4 GiB can hold.
    static void requireRoom(const Statement& statement, std::size_t count) {
        constexpr std::size_t maxCount = 1u << 31;
        if (count >= maxCount) statement.fail("there are more than 2147483648 of them");
    }

    static constexpr Vec3 white{1.0f, 1.0f, 1.0f};

    const Bytes file_;
    const Host& host_;
    const double progressEnd_;
    const std::string sceneFile_;  // empty: failures need not name it
    Lines lines_;
    std::size_t nextProgress_ = 0;
    Document document_;
    FaceState state_;
    IgnoredStatements ignored_;
    bool hasOtherGeometry_ = false;
};

}  // namespace

Document parseObj(const Bytes& file, const Host& host, double progressEnd) {
    return Parser(file, host, progressEnd).parse();
}

}  // namespace candela_plugins::obj
