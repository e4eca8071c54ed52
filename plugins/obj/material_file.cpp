#include "material_file.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "statement.h"

namespace candela_plugins::obj {
namespace {

class MaterialParser {
  public:
    MaterialParser(const std::string& file, const Host& host, std::vector<FileMaterial>& materials)
        : file_(file), host_(host), materials_(materials) {}

    /// A statement that cannot be read is noted, and the rest of the file counts.
    void read(Statement& statement) {
        try {
            readStatement(statement);
        } catch (const Failure& failure) {
            host_.note(CANDELA_NOTE_REPAIRED, failure.element, failure.reason + ": not used");
        }
    }

    void addNotes() const { notes_.add(host_, file_); }

  private:
    using Reader = void (MaterialParser::*)(Statement&);

    void readStatement(Statement& statement) {
        // Some programs write keywords in other cases.
        const std::string keyword = lowerCase(statement.keyword());
        if (keyword == "newmtl") return begin(statement);
        const auto found = readers().find(keyword);
        if (found == readers().end()) return notes_.countUnknown(statement.keyword(), statement.line());
        if (!hasMaterial_) statement.fail("no newmtl precedes it");
        (this->*found->second)(statement);
    }

    static const std::unordered_map<std::string_view, Reader>& readers() {
        using P = MaterialParser;
        static const std::unordered_map<std::string_view, Reader> table{
            {"kd", &P::readColor<&FileMaterial::diffuse>},
            {"ke", &P::readColor<&FileMaterial::emission>},
            {"ns", &P::readExponent},
            {"d", &P::readOpacity},
            {"tr", &P::readFraction<&FileMaterial::transparency>},
            {"pr", &P::readFraction<&FileMaterial::roughness>},
            {"pm", &P::readFraction<&FileMaterial::metallic>},
            {"map_kd", &P::readDiffuseMap},
            {"map_ke", &P::readMap<&FileMaterial::emissionMap>},
            {"map_d", &P::readMap<&FileMaterial::opacityMap>},
            {"map_pr", &P::readMap<&FileMaterial::roughnessMap>},
            {"map_pm", &P::readMap<&FileMaterial::metallicMap>},
            {"norm", &P::readMap<&FileMaterial::normalMap>},
            {"bump", &P::readMap<&FileMaterial::bumpMap>},
            {"map_bump", &P::readMap<&FileMaterial::bumpMap>},
            // What metallic-roughness materials have no place for, and rules of other renderers.
            {"ka", &P::skip},
            {"ks", &P::skip},
            {"ni", &P::skip},
            {"tf", &P::skip},
            {"illum", &P::skip},
            {"sharpness", &P::skip},
            {"pcr", &P::skip},
            {"anisor", &P::skip},
            {"map_ka", &P::skip},
            {"map_ks", &P::skip},
            {"map_aat", &P::skip},
            {"map_pcr", &P::skip},
            // What a picture lacks.
            {"ps", &P::noteUnlessZero},
            {"pc", &P::noteUnlessZero},
            {"aniso", &P::noteUnlessZero},
            {"map_ns", &P::noteNotDrawn},
            {"map_tr", &P::noteNotDrawn},
            {"map_ps", &P::noteNotDrawn},
            {"map_pc", &P::noteNotDrawn},
            {"map_disp", &P::noteNotDrawn},
            {"disp", &P::noteNotDrawn},
            {"decal", &P::noteNotDrawn},
            {"map_decal", &P::noteNotDrawn},
            {"refl", &P::noteNotDrawn},
            {"map_refl", &P::noteNotDrawn}};
        return table;
    }

    void begin(Statement& statement) {
        materials_.emplace_back();
        materials_.back().name = statement.rest();
        materials_.back().element =
            statement.place() + ": newmtl '" + readable(std::string(statement.rest())) + "'";
        hasMaterial_ = true;
    }

    void skip(Statement&) {}

    void noteNotDrawn(Statement& statement) {
        notes_.count(CANDELA_NOTE_MISSING, "not drawn: " + std::string(statement.keyword()),
                     statement.line());
    }

    void noteUnlessZero(Statement& statement) {
        const auto word = statement.word();
        if (!word || numberIn(*word).value_or(1.0) != 0.0) noteNotDrawn(statement);
    }

    template <std::optional<std::array<float, 3>> FileMaterial::*member>
    void readColor(Statement& statement) {
        if (statement.rest().starts_with("spectral") || statement.rest().starts_with("xyz"))
            return notes_.count(CANDELA_NOTE_MISSING,
                                "not used: " + std::string(statement.keyword()) + " other than r g b",
                                statement.line());
        // Emission has no upper limit but that of the host.
        const bool emits = member == &FileMaterial::emission;
        const double max = emits ? 1e20 : 1.0;
        std::array<float, 3> color{};
        color[0] = number(statement, statement.needWord("r g b"), max);
        // The format lets a single number stand for all three.
        color[1] = color[2] = color[0];
        if (const auto green = statement.word()) {
            color[1] = number(statement, *green, max);
            color[2] = number(statement, statement.needWord("r g b"), max);
        }
        materials_.back().*member = color;
    }

    /// Held at 0 and `max`, which is noted.
    float number(const Statement& statement, std::string_view word, double max) {
        const std::string keyword(statement.keyword());
        std::optional<double> value = numberIn(word);
        if (!value && (value = numberWithCommaIn(word)))
            host_.note(CANDELA_NOTE_REPAIRED, statement.place(),
                       keyword + ": a decimal comma, read as a point");
        if (!value || std::isnan(*value)) statement.fail(inQuotes(word) + " is not a number");
        if (*value < 0.0)
            host_.note(CANDELA_NOTE_REPAIRED, statement.place(), keyword + " is below 0: taken as 0");
        if (*value > max)
            host_.note(
                CANDELA_NOTE_REPAIRED, statement.place(),
                keyword + (max == 1.0 ? " is above 1: taken as 1" : " is too large: held at the limit"));
        return static_cast<float>(std::clamp(*value, 0.0, max));
    }

    template <std::optional<float> FileMaterial::*member>
    void readFraction(Statement& statement) {
        materials_.back().*member = number(statement, statement.needWord("a number"), 1.0);
    }

    void readExponent(Statement& statement) {
        constexpr double maxExponent = 1e30;
        materials_.back().exponent = number(statement, statement.needWord("a number"), maxExponent);
    }

    void readOpacity(Statement& statement) {
        if (statement.rest().starts_with("-halo")) {
            notes_.count(CANDELA_NOTE_MISSING, "not drawn: option -halo of d", statement.line());
            statement.word();
        }
        readFraction<&FileMaterial::opacity>(statement);
    }

    template <std::optional<TextureInfo> FileMaterial::*member>
    void readMap(Statement& statement) {
        materials_.back().*member = parseTextureInfo(statement, file_, host_, notes_);
    }

    void readDiffuseMap(Statement& statement) {
        readMap<&FileMaterial::diffuseMap>(statement);
        materials_.back().hasDiffuseMap = true;
    }

    const std::string& file_;
    const Host& host_;
    std::vector<FileMaterial>& materials_;
    LineNotes notes_;
    bool hasMaterial_ = false;
};

}  // namespace

void parseMaterialFile(const Bytes& file, const std::string& name, const Host& host,
                       std::vector<FileMaterial>& materials) {
    Lines lines(textOf(file));
    MaterialParser parser(name, host, materials);
    while (lines.next()) {
        Statement statement(lines.line(), lines.number(), name);
        parser.read(statement);
    }
    parser.addNotes();
}

}  // namespace candela_plugins::obj
