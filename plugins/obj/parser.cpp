#include "parser.h"

#include <cmath>

#include "face_parser.h"
#include "file_names.h"
#include "ignored_statements.h"
#include "lines.h"
#include "tag_parser.h"

namespace candela_obj {
namespace {

// What the host takes at most, see `validate`.
constexpr double farthest = 1e9;

/// The colours of vertices stem from pictures and scans, and are sRGB-encoded like these (IEC 61966-2-1).
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
            tellProgress();
            Statement statement(lines_.line(), lines_.number(), sceneFile_);
            read(statement);
        }
        ignored_.note(host_, sceneFile_);
        if (document_.faces.empty() && !otherShapes_)
            throw Failure{"", "no face, line or point was found, but an OBJ file was expected"};
        return std::move(document_);
    }

  private:
    void tellProgress() {
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
            leaveOut(statement, keyword);
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
        document_.positions.push_back(readVec3(statement, farthest));
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
        const float u = statement.needNumber(farthest);
        const auto second = statement.word();
        const float v = second ? statement.number(*second, farthest) : 0.0f;
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

    /// Statements that are not drawn, not used or not known; those that belong to a free-form shape that is
    /// counted already are passed over.
    void leaveOut(const Statement& statement, std::string_view keyword) {
        struct Shape {
            std::string_view keyword, kind;
        };
        static constexpr Shape shapes[] = {
            {"l", "lines (l)"},          {"p", "points (p)"},         {"curv", "curves (curv)"},
            {"curv2", "curves (curv2)"}, {"surf", "surfaces (surf)"}, {"bzp", "patches (bzp)"},
            {"bsp", "patches (bsp)"},    {"cdp", "patches (cdp)"},    {"cdc", "curves (cdc)"}};
        static constexpr std::string_view freeForm[] = {"vp",   "cstype", "deg",   "bmat", "step", "parm",
                                                        "trim", "hole",   "scrv",  "sp",   "end",  "con",
                                                        "mg",   "res",    "ctech", "stech"};
        static constexpr std::string_view unused[] = {"bevel",  "c_interp",   "d_interp",  "lod",  "usemap",
                                                      "maplib", "shadow_obj", "trace_obj", "call", "csh"};
        for (const Shape& shape : shapes) {
            if (keyword != shape.keyword) continue;
            otherShapes_ = true;
            return ignored_.count("not drawn", shape.kind, statement.line());
        }
        for (const std::string_view part : freeForm)
            if (keyword == part) return;
        for (const std::string_view known : unused)
            if (keyword == known) return ignored_.count("not used", keyword, statement.line());
        ignored_.count("not known", keyword, statement.line());
    }

    /// Indices have 32 bits, and a face adds fewer corners than a file of 4 GiB can hold.
    static void requireRoom(const Statement& statement, std::size_t count) {
        constexpr std::size_t most = 1u << 31;
        if (count >= most) statement.fail("there are more than 2147483648 of them");
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
    bool otherShapes_ = false;
};

}  // namespace

Document parseObj(const Bytes& file, const Host& host, double progressEnd) {
    return Parser(file, host, progressEnd).parse();
}

}  // namespace candela_obj
